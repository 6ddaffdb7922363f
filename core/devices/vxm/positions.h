#pragma once
// Reads and shows the positions, and the motions that they reveal.
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/identification.h"
#include "core/devices/vxm/motor_readings.h"
#include "core/devices/vxm/ramp.h"
#include "core/devices/vxm/signals.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class Positions {
 public:
  Positions(const Console& console, Conversation& conversation, const Identification& identification,
            Signals& signals, MotorReadings& readings, Hold& hold, Ramp& ramp, const UnderWay& under_way)
      : console_(console),
        conversation_(conversation),
        identification_(identification),
        signals_(signals),
        readings_(readings),
        hold_(hold),
        ramp_(ramp),
        under_way_(under_way) {}

  /// Reads all readable positions: at rest, the Slave's too.
  Task<Result<>> read(Priority priority, bool at_rest, bool and_a_signal = false);
  /// Shows the position received last.
  void show(int axis, Steps position);
  /// N was sent.
  void are_zero();

 private:
  void program_has_begun_a_way(const MotorReadings::Change& way);

  const Console& console_;
  Conversation& conversation_;
  const Identification& identification_;
  Signals& signals_;
  MotorReadings& readings_;
  Hold& hold_;
  Ramp& ramp_;
  const UnderWay& under_way_;
};

}  // namespace hw::vxm
