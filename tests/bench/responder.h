#pragma once
// The cheapest conceivable controller at the other end of a TCP connection: a child process in plain C that
// answers a VXM's questions at once. Both ends run on one core, so that a round trip costs the sum of both.
namespace hw {

class Responder {
 public:
  Responder();   ///< forks; pins parent and child to core 0
  ~Responder();  ///< ends the child, unpins
  Responder(const Responder&) = delete;
  [[nodiscard]] int port() const { return port_; }

 private:
  int port_ = 0;
  int child_ = 0;
};

}  // namespace hw
