#pragma once
// Leaves a call of Lua's library that does not return, such as a pattern that backtracks for ever. A signal
// is sent to the thread; its handler jumps to the place where the script was resumed. Closed while C++ runs
// or memory is allocated. Never touch the Lua state after the jump.
#include <atomic>
#include <csetjmp>
#include <csignal>
#include <cstdint>

#include <pthread.h>

namespace hw::script {

class WayOut {
 public:
  /// For the constructing thread. `beat` changes while the script makes progress.
  explicit WayOut(const std::atomic<std::uint64_t>& beat);
  ~WayOut();
  WayOut(const WayOut&) = delete;
  WayOut& operator=(const WayOut&) = delete;

  /// Runs Lua. False: left through the way out.
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
  /// Any thread: takes the way out if the beat still is `seen`.
  void take(std::uint64_t seen);

  /// Call when Lua's own code runs: a Lua error, such as out of memory, may have jumped past the end of a
  /// Closed.
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
