#pragma once
// Runs of stored programs: start, hold, resume, single step.
#include "core/devices/vxm/admission.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/hold_switch.h"
#include "core/devices/vxm/legs.h"
#include "core/devices/vxm/motor_readings.h"
#include "core/devices/vxm/ramp.h"
#include "core/devices/vxm/slots.h"
#include "core/devices/vxm/speeds.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class Runs {
 public:
  Runs(const Console& console, Conversation& conversation, Slots& slots, Speeds& speeds,
       const MotorReadings& readings, const Hold& hold, HoldSwitch& hold_switch, Ramp& ramp,
       UnderWay& under_way, Admission& admission, Legs& legs)
      : console_(console),
        conversation_(conversation),
        slots_(slots),
        speeds_(speeds),
        readings_(readings),
        hold_(hold),
        hold_switch_(hold_switch),
        ramp_(ramp),
        under_way_(under_way),
        admission_(admission),
        legs_(legs) {}

  Task<Result<>> run(int slot);
  Task<Result<>> pause();
  Task<Result<>> resume();
  Task<Result<>> single_step();
  /// Call once the limits have been read after its end.
  void find_end_of_run();

 private:
  [[nodiscard]] bool looks_for_switches(int slot, int motor) const;
  [[nodiscard]] bool may_turn(int slot, int motor) const;

  const Console& console_;
  Conversation& conversation_;
  Slots& slots_;
  Speeds& speeds_;
  const MotorReadings& readings_;
  const Hold& hold_;
  HoldSwitch& hold_switch_;
  Ramp& ramp_;
  UnderWay& under_way_;
  Admission& admission_;
  Legs& legs_;
};

}  // namespace hw::vxm
