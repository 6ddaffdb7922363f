#pragma once
// K, which ends everything without a ramp, and its cost in position.
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/headline.h"
#include "core/devices/vxm/identification.h"
#include "core/devices/vxm/motor_readings.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

/// Patience for the reply to K, or to an urgent question beside it.
inline constexpr Duration kill_patience = Millis(300);

class Kills {
 public:
  Kills(const Console& console, Conversation& conversation, const Presence& presence,
        const Identification& identification, const MotorReadings& readings, UnderWay& under_way,
        const Headline& headline)
      : console_(console),
        conversation_(conversation),
        presence_(presence),
        identification_(identification),
        readings_(readings),
        under_way_(under_way),
        headline_(headline) {}

  /// `standing`: K costs no steps.
  Task<Result<>> kill(bool standing, Priority priority = Priority::stop);
  /// Doubts the positions of all motors that a K stops now, as far as known.
  void doubt_positions() const;

 private:
  const Console& console_;
  Conversation& conversation_;
  const Presence& presence_;
  const Identification& identification_;
  const MotorReadings& readings_;
  UnderWay& under_way_;
  const Headline& headline_;
};

}  // namespace hw::vxm
