#pragma once
// Rounds of status: when the next one is due, how often they come, and which of them somebody waits for. What
// a stop asks while it is under way is no round: see Round::stopping. Io thread.
#include <algorithm>
#include <cstdint>

#include "core/time/clock.h"

namespace hw {

class Rounds {
 public:
  [[nodiscard]] Instant next() const { return next_; }
  void due_at(Instant when) { next_ = when; }
  /// Something was sent. A controller's status may lag behind the command by a round or two.
  void look_often(Instant now) {
    constexpr int rounds_after_a_command = 3;
    next_ = now;
    often_ = rounds_after_a_command;
  }
  [[nodiscard]] bool often() const { return often_ > 0; }

  void begin() { ++begun_; }
  void cut() { --begun_; }
  void end() { ended_ = begun_; }
  /// The next one is due a `period` from now, or at once when somebody waits for it.
  void schedule(Instant now, Duration period) {
    if (often_ > 0) --often_;
    next_ = ended_ < wanted_ ? now : now + period;
  }

  /// Somebody waits for the first one that begins after this; its number, which ended() reaches when it is
  /// over.
  std::uint64_t want(Instant now) {
    wanted_ = std::max(wanted_, begun_ + 1);
    next_ = now;
    return begun_ + 1;
  }
  [[nodiscard]] bool one_is_wanted() const { return wanted_ > begun_; }
  [[nodiscard]] std::uint64_t ended() const { return ended_; }

 private:
  Instant next_{};
  std::uint64_t begun_ = 0, ended_ = 0, wanted_ = 0;
  int often_ = 0;  ///< so many of the next rounds
};

}  // namespace hw
