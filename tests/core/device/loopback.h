#pragma once
// An emulated controller at the other end of a wire, in virtual time, with the byte times of its rate if
// wanted.
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "core/emulation/emulator.h"
#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw::test {

class Loopback {
 public:
  Loopback(Scheduler& scheduler, std::unique_ptr<Emulator> emulator, bool byte_times);
  ~Loopback();

  /// A new cable. Closed by pull().
  std::unique_ptr<Stream> plug();
  void pull();
  void garble(int bytes) { garble_ += bytes; }
  void drop(int bytes) { drop_ += bytes; }
  /// The same of those on their way to the controller.
  void lose(int bytes) { lose_ += bytes; }
  /// What no controller has said comes in.
  void inject(std::string_view bytes);
  /// Both ways nothing arrives, and nobody is told.
  void silence(bool on) { silent_ = on; }
  /// A program that answers everything in its own way stands in for the controller.
  void replace_by(std::string (*other)(std::string_view)) { other_ = other; }

  /// What becomes on its way of what a byte has brought, and how late all is from there on.
  struct OnItsWay {
    std::string bytes;
    Duration late{};
  };
  std::function<OnItsWay(char sentence, std::string answer)> on_its_way;

  Emulator& emulator() { return *emulator_; }
  Result<> operate(const BenchCommand& command);
  int client_rate = 0;        ///< 0: that of the controller
  std::string to_controller;  ///< every byte that was sent

 private:
  class End;
  struct Byte {
    Instant at;
    char value;
  };
  void sent(std::string_view bytes);
  void step();
  void schedule();
  [[nodiscard]] Duration byte_time() const;

  Scheduler& scheduler_;
  std::unique_ptr<Emulator> emulator_;
  bool byte_times_;
  Timer timer_;
  std::deque<Byte> in_, out_;
  Instant in_free_{}, out_free_{};
  End* end_ = nullptr;
  int garble_ = 0, drop_ = 0, lose_ = 0;
  bool silent_ = false;
  std::string (*other_)(std::string_view) = nullptr;
};

}  // namespace hw::test
