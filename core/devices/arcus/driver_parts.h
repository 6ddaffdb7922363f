#pragma once
// The parts of the driver in two groups; the second uses the first. driver_parts.cpp constructs them and so
// shows which part uses which.
#include <functional>
#include <string_view>

#include "core/devices/arcus/actions.h"
#include "core/devices/arcus/feed.h"
#include "core/devices/arcus/guard_thread.h"
#include "core/devices/arcus/lines.h"
#include "core/devices/arcus/programs.h"

namespace hw::arcus {

/// The known state of the controller, and the status rounds that read it.
struct Known {
  /// `restarted`: how it shows, and a bit for each axis that was moving.
  Known(const Console& console, Conversation& conversation,
        std::function<void(std::string_view how_it_shows, unsigned moved)> restarted);

  CodeAtWork code;
  BorrowedSetting borrowed;
  SetUp setup;
  MoveList list;
  Readouts readouts;
  RestartWatch watch;
  Motions motions;
  LimitSwitches limits;
  MotionStatus status;
  Threads threads;
  Lines lines;
};

/// Carries out the console's commands.
struct Work {
  Work(const Console& console, Conversation& conversation, Known& known, const language::Dialect& dialect);

  Moves moves;
  Feed feed;
  Actions actions;
  LiveStatus live;
  StoredLines stored;
  GuardThread guard;
  Programs programs;
};

}  // namespace hw::arcus
