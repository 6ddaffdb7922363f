#pragma once
// Decides from readings of command and encoder whether a servo axis has reached its target.
#include <cstdint>
#include <optional>

#include "core/device/snapshot.h"
#include "core/time/clock.h"

namespace hw::vme58 {

/// Deadband in counts where HD is not set (decision M80: HD starts at 0, which no loop holds).
inline constexpr std::int64_t usual_deadband = 10;

class ServoPlace {
 public:
  static constexpr Duration to_be_sure = Millis(100);  ///< an axis is in place after this time in the band
  static constexpr Duration patience =
      std::chrono::seconds(2);  ///< an axis is off its place after this time without having been in place

  /// Takes a reading. `turns`: the command is moving. An axis at rest when first seen counts as having stood
  /// there for long.
  void look(Instant at, bool turns, std::int64_t error, std::int64_t band);
  /// Something other than its command makes the axis move: it gets as much time to arrive as after a command.
  void begin(Instant at);
  /// following, in_place or off_place; unknown: no reading yet.
  [[nodiscard]] Loop place() const { return place_; }
  /// It is not yet decided whether the axis arrives.
  [[nodiscard]] bool undecided() const { return place_ == Loop::following; }
  /// It is undecided, and the command has ended.
  [[nodiscard]] bool settles() const { return undecided() && !turns_; }

 private:
  Loop place_ = Loop::unknown;
  bool turns_ = false;
  Instant due_since_{};  ///< when the command stopped, or the axis left its place
  std::optional<Instant> within_since_;
};

}  // namespace hw::vme58
