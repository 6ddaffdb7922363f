#pragma once
// Whether the count of an axis can be trusted as its position, and why not.
#include <cstdint>

#include "core/base/units.h"
#include "core/time/clock.h"

namespace hw {

enum class Trust : std::uint8_t {
  counted,   ///< counted from an unknown zero
  homed,     ///< the count was set by homing
  set,       ///< the count was set by hand
  untrusted  ///< the axis may not stand where it counts: see Doubt
};

/// What has made a count doubtful.
enum class Doubt : std::uint8_t {
  none,
  power_cut,      ///< the controller was switched off and on
  restarted,      ///< switched off and on, or reset from elsewhere: which of the two cannot be seen
  after_silence,  ///< the count read zero after a silence: switched off and on, or set by a sent command
  reset,          ///< reset by a command
  killed,         ///< stopped without a ramp from a speed at which a motor overshoots
  slipped,        ///< the encoder of a step motor differed from its count
  zero_since,     ///< the count reads zero, and an earlier session left the axis elsewhere
  another         ///< the count was changed without a motion, and not by this program
};

struct PositionTrust {
  Trust kind = Trust::counted;
  Doubt cause = Doubt::none;
  Instant since{};
  bool restored = false;  ///< from an earlier session that left the axis at the same count: KeptPosition

  void doubt(Doubt why, Instant when) { *this = {Trust::untrusted, why, when}; }
  void settle(Trust how, Instant when) { *this = {how, Doubt::none, when}; }
  [[nodiscard]] bool doubtful() const { return kind == Trust::untrusted; }
  bool operator==(const PositionTrust&) const = default;
};

/// The position at which an earlier session left an axis, and its trust.
struct KeptPosition {
  bool known = false;
  Steps position{};
  PositionTrust trust;
  bool operator==(const KeptPosition&) const = default;
};

/// The trust of an axis that counts `now` and is otherwise unknown. The same count, unless it is zero, proves
/// that the controller was not switched off; zero instead of another count proves that it was, or that the
/// count was set. Any other count proves nothing. A move does not remove a doubt.
inline PositionTrust recalled(const KeptPosition& kept, Steps now, Instant at) {
  PositionTrust trust;
  if (!kept.known || kept.trust.kind == Trust::counted) return trust;
  const bool settled = !kept.trust.doubtful(), same = now == kept.position && now != Steps(0);
  if (settled && now == Steps(0) && kept.position != Steps(0)) {
    trust.doubt(Doubt::zero_since, at);
  } else if (!settled || same) {
    trust = kept.trust;
    trust.restored = true;
  }
  return trust;
}

}  // namespace hw
