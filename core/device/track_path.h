#pragma once
// The track of a rehearsal as the way of a tool in two or three of its axes.
#include <optional>
#include <span>
#include <vector>

#include "core/device/language.h"
#include "core/drawing/tool_path.h"

namespace hw {

struct TrackAxes {
  struct Axis {
    int place = 0;              ///< in the catalog
    double units_per_step = 1;  ///< negative: counts against the steps
    bool operator==(const Axis&) const = default;
  };
  Axis right, up;
  std::optional<Axis> third = {};
  int tool_output = -1;  ///< bit of RehearsedPlace::outputs that switches the tool; -1: none, it is always on
  bool operator==(const TrackAxes&) const = default;
};

/// `line_of_command`: by RehearsedEvent::command of program `slot`, which line of its text that is.
drawing::ToolPath track_path(const Rehearsal& rehearsal, const TrackAxes& axes, int slot,
                             std::span<const int> line_of_command);

/// For the above, of an analysed text.
std::vector<int> lines_of_commands(const ProgramReport& report, int slot);

}  // namespace hw
