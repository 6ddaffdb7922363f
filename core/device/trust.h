#pragma once
// How far the count of an axis can be taken for the place where it stands.
#include <cstdint>

#include "core/time/clock.h"

namespace hw {

enum class Trust : std::uint8_t {
  counted,   ///< the controller counts; nobody has said from where
  homed,     ///< its home has set the count
  set,       ///< somebody has said where it stands
  untrusted  ///< it counts, and may stand elsewhere: see Doubt
};

/// What has made a count doubtful.
enum class Doubt : std::uint8_t {
  none,
  power_cut,  ///< it was switched off and on
  restarted,  ///< that, or somebody else's reset: it does not show which
  unheard,    ///< it did not answer, and then it read zero: that, or what was sent has set it
  reset,      ///< by a command
  killed,     ///< stopped without a ramp from a speed at which a motor overshoots
  slipped     ///< a step motor whose encoder lay elsewhere than its count
};

struct PositionTrust {
  Trust kind = Trust::counted;
  Doubt cause = Doubt::none;
  Instant since{};

  void doubt(Doubt why, Instant when) { *this = {Trust::untrusted, why, when}; }
  void settle(Trust how, Instant when) { *this = {how, Doubt::none, when}; }
  [[nodiscard]] bool doubtful() const { return kind == Trust::untrusted; }
  bool operator==(const PositionTrust&) const = default;
};

}  // namespace hw
