#pragma once
// The console's end of its watchdog, a process that briefly outlives the console: see will_message.h.
#include <memory>
#include <string>
#include <vector>

#include "core/link/last_will.h"

namespace hw {

class JogWatchdog final : public WillKeeper {
 public:
  /// Starts the first existing program of `places`. Call before any thread begins, so that no half-made state
  /// is inherited. If the watchdog does not start, the console says so and works without it.
  static std::shared_ptr<JogWatchdog> start(const std::vector<std::string>& places);
  ~JogWatchdog() override;
  JogWatchdog(const JogWatchdog&) = delete;
  JogWatchdog& operator=(const JogWatchdog&) = delete;

  std::shared_ptr<Will> leave(Scheduler& scheduler, const WireShare& wire, const LastWill& will) override;
  [[nodiscard]] bool is_there() const override;
  /// Makes a fatal signal of this process reach the watchdog at once, because a core dump takes time.
  void report_fatal_signals() const;

 private:
  struct Talk;
  class ActiveWill;
  explicit JogWatchdog(std::shared_ptr<Talk> talk) : talk_(std::move(talk)) {}
  std::shared_ptr<Talk> talk_;  // wills outlive this object
  std::uint32_t last_id_ = 0;
};

}  // namespace hw
