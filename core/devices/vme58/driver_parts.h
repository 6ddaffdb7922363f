#pragma once
// The parts of the driver in four groups, each made of those before it. A part names what it needs of others
// where it is made: driver_parts.cpp.
#include "core/device/driver.h"
#include "core/devices/vme58/actions.h"
#include "core/devices/vme58/board_options.h"
#include "core/devices/vme58/setup.h"
#include "core/devices/vme58/stops.h"
#include "core/devices/vme58/texts.h"

namespace hw::vme58 {

/// How the board is spoken to: its bus, its rings, its mailbox.
struct Talk {
  Talk(DriverContext& context, Readings::Listener& listener);

  Wire wire;
  Selection selection;
  Readings readings;
  Conversation conversation;
  Mailbox mailbox;
  Commands commands;
};

/// What is known of the board, and what is asked for it in rounds of status.
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

/// What the console is asked to do by its controls.
struct Work {
  Work(Talk& talk, Known& known, DriverContext& context);

  ServoDrive drive;
  Moves moves;
  Actions actions;
  Setup setup;
};

/// Command strings and stops: a string may stop axes, and a stop ends strings and programs.
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
