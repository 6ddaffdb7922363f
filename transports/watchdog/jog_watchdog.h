#pragma once
// The console's end of its watchdog: a process that outlives this one for a moment, see will_message.h.
#include <memory>
#include <string>
#include <vector>

#include "core/link/last_will.h"

namespace hw {

class JogWatchdog final : public WillKeeper {
 public:
  /// Starts the first program of `places` that is there. Before any thread begins, so that nothing is
  /// inherited half-way. A console whose watchdog does not start works without one, and says so.
  static std::shared_ptr<JogWatchdog> start(const std::vector<std::string>& places);
  ~JogWatchdog() override;
  JogWatchdog(const JogWatchdog&) = delete;
  JogWatchdog& operator=(const JogWatchdog&) = delete;

  std::shared_ptr<Will> leave(Scheduler& scheduler, const WireShare& wire, const LastWill& will) override;
  [[nodiscard]] bool is_there() const override;
  /// A fatal signal of this process is told to the watchdog at once: a core dump takes its time.
  void tell_fatal_signals() const;

 private:
  struct Talk;
  class Left;
  explicit JogWatchdog(std::shared_ptr<Talk> talk) : talk_(std::move(talk)) {}
  std::shared_ptr<Talk> talk_;  // outlived by wills
  std::uint32_t last_id_ = 0;
};

}  // namespace hw
