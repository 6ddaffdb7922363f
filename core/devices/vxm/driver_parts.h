#pragma once
// The parts of the driver in groups, each made of those before it. A part names what it needs of others where
// it is made: driver_parts.cpp.
#include <functional>

#include "core/devices/vxm/admission.h"
#include "core/devices/vxm/echo.h"
#include "core/devices/vxm/moves.h"
#include "core/devices/vxm/opening.h"
#include "core/devices/vxm/runs.h"
#include "core/devices/vxm/status_rounds.h"
#include "core/devices/vxm/stops.h"
#include "core/devices/vxm/texts.h"
#include "core/devices/vxm/unasked.h"

namespace hw::vxm {

/// What is known of the controller.
struct Known {
  /// `may_change`: it takes changes of its set-up and programs now.
  Known(const Console& console, Conversation& talk, const std::function<Result<>()>& may_change);

  Nameplate nameplate;
  Signals signals;
  Parameters parameters;
  Slots slots;
  Scratch scratch;
  Sight sight;
  Speeds speeds;
  Hold hold;
  Knowledge knowledge;
};

/// What goes on in it, what it may be asked for, and what ends that.
struct Course {
  Course(const Console& console, Conversation& talk, Known& known);

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

/// What the console is asked to do.
struct Work {
  Work(const Console& console, Conversation& talk, Known& known, Course& course);

  Legs legs;
  Moves moves;
  Runs runs;
  Stops stops;
  Texts texts;
};

/// What is heard of it: when it is opened, in rounds, and unasked.
struct Watch {
  Watch(const Console& console, Conversation& talk, Known& known, Course& course, Work& work);

  Echo echo;
  Opening opening;
  StatusRounds rounds;
  Unasked unasked;
};

}  // namespace hw::vxm
