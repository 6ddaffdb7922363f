#pragma once
// The parts of the driver in groups, each built on those before it. The dependencies of a part are named
// where it is made: driver_parts.cpp.
#include <functional>

#include "core/devices/vxm/admission.h"
#include "core/devices/vxm/echo.h"
#include "core/devices/vxm/moves.h"
#include "core/devices/vxm/opening.h"
#include "core/devices/vxm/runs.h"
#include "core/devices/vxm/status_rounds.h"
#include "core/devices/vxm/stops.h"
#include "core/devices/vxm/texts.h"
#include "core/devices/vxm/unsolicited_messages.h"

namespace hw::vxm {

/// Knowledge of the controller.
struct Known {
  /// `may_change`: set-up and programs may be changed now.
  Known(const Console& console, Conversation& conversation, const std::function<Result<>()>& may_change);

  Identification identification;
  Signals signals;
  Parameters parameters;
  Slots slots;
  Scratch scratch;
  MotorReadings readings;
  Speeds speeds;
  Hold hold;
  Knowledge knowledge;
};

/// Tracks motions and runs, admits new ones, and ends them.
struct Course {
  Course(const Console& console, Conversation& conversation, Known& known);

  Presence presence;
  Ramp ramp;
  UnderWay under_way;
  Positions positions;
  Headline headline;
  Kills kills;
  HoldSwitch hold_switch;
  Admission admission;
  Restarts restarts;
  Status status;
};

/// Carries out requests.
struct Work {
  Work(const Console& console, Conversation& conversation, Known& known, Course& course);

  Legs legs;
  Moves moves;
  Runs runs;
  Stops stops;
  Texts texts;
};

/// Follows the controller: on opening, in status rounds, and by unsolicited messages.
struct Watch {
  Watch(const Console& console, Conversation& conversation, Known& known, Course& course, Work& work);

  Echo echo;
  Opening opening;
  StatusRounds rounds;
  UnsolicitedMessages unsolicited;
};

}  // namespace hw::vxm
