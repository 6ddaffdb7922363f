#pragma once
// The cheapest controller at the other end of a TCP connection: a child process that reads, asks an emulator
// whose time stands still, and writes. Both ends run on one core, so that a round trip costs the sum of both.
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
