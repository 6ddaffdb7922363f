#pragma once
// The records of one controller: traffic, events, its stops, the path that its axes took. GUI thread.
#include <string>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"
#include "gui/model/event_log.h"
#include "gui/model/position_trace.h"
#include "gui/model/stop_times.h"
#include "gui/model/traffic_log.h"

namespace hw::gui {

struct Records {
  explicit Records(TrafficLog::Explain explain) : traffic(explain) {}

  TrafficLog traffic;
  EventLog events;
  StopTimes stop_times;
  PositionTrace trace;

  /// A motion, program, list or drawing has ended.
  void add(const Ending& ending, const Catalog& catalog, const EventLog::ShowPosition& position);
  /// Keeps a user action among the events, where a flood of traffic cannot push it out.
  void note(std::string words, Instant clock);
};

}  // namespace hw::gui
