#pragma once
// The way out of a call of Lua's library that does not come back, as from a pattern that backtracks for ever:
// a signal to the thread that is in there, whose handler jumps to where the script was resumed. It is closed
// while C++ runs or memory is allocated. What it leaves of the Lua state may not be touched any more.
#include <atomic>
#include <csetjmp>
#include <csignal>
#include <cstdint>

#include <pthread.h>

namespace hw::script {

class WayOut {
 public:
  /// For the thread that makes it. `beat` changes with every sign of life of the script.
  explicit WayOut(const std::atomic<std::uint64_t>& beat);
  ~WayOut();
  WayOut(const WayOut&) = delete;
  WayOut& operator=(const WayOut&) = delete;

  /// Runs Lua. False: the way out was taken.
  template <class Call>
  bool through(Call call) {
    if (sigsetjmp(place_, 0) != 0) {
      closed_ = 1;
      return false;
    }
    closed_ = 0;
    call();
    closed_ = 1;
    return true;
  }
  /// Any thread: takes it, if the script has given no sign of life since `seen`.
  void take(std::uint64_t seen);

  /// Lua's own code runs. An error of Lua's, as when memory is short, may have jumped past a Closed's end.
  void open() { closed_ = 0; }

  /// No code of the script may run meanwhile.
  class Closed {
   public:
    explicit Closed(WayOut& way) : way_(way), before_(way.closed_) { way_.closed_ = 1; }
    ~Closed() { way_.closed_ = before_; }
    Closed(const Closed&) = delete;
    Closed& operator=(const Closed&) = delete;

   private:
    WayOut& way_;
    const std::sig_atomic_t before_;
  };

 private:
  static void on_signal(int);

  const std::atomic<std::uint64_t>& beat_;
  std::atomic<std::uint64_t> seen_{0};
  const pthread_t thread_;
  volatile std::sig_atomic_t closed_ = 1;
  sigjmp_buf place_{};
  struct sigaction before_ {};
};

}  // namespace hw::script
