#pragma once
// Stops, by decision V102. D ends a move of the console. A stored program is held (H), its motor ramped down
// (D), and the program ended by K once everything stands. A stop at once is K. In Local mode: F (on-line),
// then K.
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/hold_switch.h"
#include "core/devices/vxm/kills.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/ramp.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class Stops {
 public:
  Stops(const Console& console, Conversation& conversation, Presence& presence, UnderWay& under_way,
        Ramp& ramp, Kills& kills, HoldSwitch& hold_switch)
      : console_(console),
        conversation_(conversation),
        presence_(presence),
        under_way_(under_way),
        ramp_(ramp),
        kills_(kills),
        hold_switch_(hold_switch) {}

  Task<Result<>> send(const StopOrder& order);
  /// One motor jogs at a time, and D ends whatever runs.
  static LastWill last_will();
  /// Progress of the stop.
  StopProgress progress(const StopOrder& order);

 private:
  Task<Result<>> stop_blind(const StopOrder& order);
  Task<Result<>> stop_local();
  Task<Result<>> switch_tool_off();
  Task<Result<>> stop_leg(const StopOrder& order);
  Task<Result<>> ramp_down();
  Task<Result<>> stop_program(const StopOrder& order);
  Task<Result<>> stop_unknown();
  void show_stopping();

  const Console& console_;
  Conversation& conversation_;
  Presence& presence_;
  UnderWay& under_way_;
  Ramp& ramp_;
  Kills& kills_;
  HoldSwitch& hold_switch_;
};

}  // namespace hw::vxm
