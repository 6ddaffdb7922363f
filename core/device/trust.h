#pragma once
// How far the count of an axis can be taken for the place where it stands.
#include <cstdint>

#include "core/base/units.h"
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
  power_cut,   ///< it was switched off and on
  restarted,   ///< that, or somebody else's reset: it does not show which
  unheard,     ///< it did not answer, and then it read zero: that, or what was sent has set it
  reset,       ///< by a command
  killed,      ///< stopped without a ramp from a speed at which a motor overshoots
  slipped,     ///< a step motor whose encoder lay elsewhere than its count
  zero_since,  ///< it reads zero, and stood elsewhere when an earlier session left it
  another      ///< its count has changed otherwise than by a motion, and not by this program
};

struct PositionTrust {
  Trust kind = Trust::counted;
  Doubt cause = Doubt::none;
  Instant since{};
  bool restored = false;  ///< learned in an earlier session, which left it at the same count: KeptPosition

  void doubt(Doubt why, Instant when) { *this = {Trust::untrusted, why, when}; }
  void settle(Trust how, Instant when) { *this = {how, Doubt::none, when}; }
  [[nodiscard]] bool doubtful() const { return kind == Trust::untrusted; }
  bool operator==(const PositionTrust&) const = default;
};

/// Where an earlier session left an axis, and how far that was to be trusted.
struct KeptPosition {
  bool known = false;
  Steps position{};
  PositionTrust trust;
  bool operator==(const KeptPosition&) const = default;
};

/// What is to be thought of an axis that counts `now`, of which nothing else is known. The same count, but
/// for zero, proves that the controller has not been switched off; zero where it was elsewhere, that it has
/// been, or that somebody has set it. Any other count proves nothing. Doubt is not healed by a move.
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
