#pragma once
// K, which ends everything without a ramp, and what it costs.
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/headline.h"
#include "core/devices/vxm/nameplate.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/sight.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

/// The answer to K, or to what is asked in a hurry beside it.
inline constexpr Duration kill_patience = Millis(300);

class Kills {
 public:
  Kills(const Console& console, Conversation& talk, const Presence& presence, const Nameplate& nameplate,
        const Sight& sight, UnderWay& under_way, const Headline& headline)
      : console_(console),
        talk_(talk),
        presence_(presence),
        nameplate_(nameplate),
        sight_(sight),
        under_way_(under_way),
        headline_(headline) {}

  /// `standing`: it costs no steps.
  Task<Result<>> kill(bool standing, Priority priority = Priority::stop);
  /// Of all that a K ends now, as far as is known.
  void doubt_positions() const;

 private:
  const Console& console_;
  Conversation& talk_;
  const Presence& presence_;
  const Nameplate& nameplate_;
  const Sight& sight_;
  UnderWay& under_way_;
  const Headline& headline_;
};

}  // namespace hw::vxm
