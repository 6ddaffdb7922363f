#pragma once
// The track of a rehearsal as a tool path in two or three axes, or as one axis over time.
#include <optional>
#include <span>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/language.h"
#include "core/drawing/tool_path.h"
#include "core/sequence/sequence.h"

namespace hw {

struct TrackAxes {
  struct Axis {
    int place = 0;              ///< in the catalog
    double units_per_step = 1;  ///< negative: counts against the steps
    int track = 0;              ///< with several controllers: which one
    bool operator==(const Axis&) const = default;
  };
  /// An axis that lowers the tool. The tool is on below the middle of that travel.
  struct Lowering {
    int place = 0;
    std::int64_t half_way = 0;
    bool down_is_plus = false;
    bool operator==(const Lowering&) const = default;
  };
  Axis right, up;
  std::optional<Axis> third = {};
  int tool_output =
      -1;  ///< bit of RehearsedPlace::outputs that switches the tool; -1: none, the tool is always on
  bool tool_is_on_when = true;          ///< the level of that output with the tool on
  std::optional<Lowering> lowers = {};  ///< if no output switches it
  bool over_time = false;               ///< seconds go to the right; `right` is not shown
  bool operator==(const TrackAxes&) const = default;
};

/// Takes the tool from the routines of the sequence: an output, else an axis. False: they switch none, and
/// nothing is changed.
bool take_tool_of(const sequence::Sequence& sequence, const Catalog& catalog, TrackAxes& axes);

/// `line_of_command`: the line of text for RehearsedEvent::command of program `slot`. The pass of a run
/// counts how often its line began before.
drawing::ToolPath track_path(const Rehearsal& rehearsal, const TrackAxes& axes, int slot,
                             std::span<const int> line_of_command);

/// The path of several controllers that begin at once; the tool is that of the first, and no run has a
/// source.
drawing::ToolPath track_path_together(std::span<const Rehearsal> all, const TrackAxes& axes);

/// `line_of_command` of an analysed text.
std::vector<int> lines_of_commands(const ProgramReport& report, int slot);

}  // namespace hw
