#pragma once
// Status rounds: when the next one is due, how often they come, and which ones are waited for. The questions
// of a pending stop are not a round: see Round::stopping. Io thread.
#include <algorithm>
#include <cstdint>

#include "core/time/clock.h"

namespace hw {

class Rounds {
 public:
  [[nodiscard]] Instant next() const { return next_; }
  void due_at(Instant when) { next_ = when; }
  /// A command was sent. A controller's status may lag behind it by a round or two.
  void look_often(Instant now) {
    constexpr int rounds_after_a_command = 3;
    next_ = now;
    often_ = rounds_after_a_command;
  }
  [[nodiscard]] bool often() const { return often_ > 0; }

  void begin() { ++begun_; }
  void cut() { --begun_; }
  void end() { ended_ = begun_; }
  /// The next round is due after `period`, or at once if it is waited for.
  void schedule(Instant now, Duration period) {
    if (often_ > 0) --often_;
    next_ = ended_ < wanted_ ? now : now + period;
  }

  /// Requests a round that begins after this call; returns the number that ended() reaches when it is over.
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
  int often_ = 0;  ///< how many of the next rounds follow each other quickly
};

}  // namespace hw
