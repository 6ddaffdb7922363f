#pragma once
// The parts of the driver in four groups, each built on the groups before it. driver_parts.cpp shows which
// other parts each one needs.
#include "core/device/driver.h"
#include "core/devices/vme58/actions.h"
#include "core/devices/vme58/board_options.h"
#include "core/devices/vme58/setup.h"
#include "core/devices/vme58/stops.h"
#include "core/devices/vme58/texts.h"

namespace hw::vme58 {

/// Communication with the board: bus, rings, mailbox.
struct Talk {
  Talk(DriverContext& context, Readings::Listener& listener);

  Wire wire;
  Selection selection;
  Readings readings;
  Conversation conversation;
  Mailbox mailbox;
  Commands commands;
};

/// Knowledge of the board, and the questions of the status rounds.
struct Known {
  Known(Talk& talk, const Variant& variant, DriverContext& context);
  void forget();

  NextRound next;
  Queues queues;
  ParameterValues values;
  LimitEnds limits;
  ServoLoops loops;
  Motions motions;
  Speeds speeds;
  StatusQuestions questions;
  Lines lines;
};

/// Requests from the console's controls.
struct Work {
  Work(Talk& talk, Known& known, DriverContext& context);

  ServoDrive drive;
  Moves moves;
  Actions actions;
  Setup setup;
};

/// Command strings and stops: a string can stop axes, and a stop ends strings and programs.
struct Strings {
  Strings(Talk& talk, Known& known, DriverContext& context);
  void forget();

  StopEffect stop_effect;
  AllStop all_stop;
  Effects effects;
  Feed feed;
  Programs programs;
  Stops stops;
  Texts texts;
};

}  // namespace hw::vme58
