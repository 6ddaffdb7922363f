#pragma once
// The track of a rehearsal as the way of a tool in two or three of its axes, or of one axis over time.
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
    int track = 0;              ///< of several controllers: whose
    bool operator==(const Axis&) const = default;
  };
  /// An axis that lowers the tool. It is on further down than half of that way.
  struct Lowering {
    int place = 0;
    std::int64_t half_way = 0;
    bool down_is_plus = false;
    bool operator==(const Lowering&) const = default;
  };
  Axis right, up;
  std::optional<Axis> third = {};
  int tool_output = -1;  ///< bit of RehearsedPlace::outputs that switches the tool; -1: none, it is always on
  bool tool_is_on_when = true;          ///< of that output
  std::optional<Lowering> lowers = {};  ///< where no output switches it
  bool over_time = false;               ///< to the right go seconds, and `right` is not seen
  bool operator==(const TrackAxes&) const = default;
};

/// Has the axes tell the tool as the routines of the sequence switch it: by an output, else by an axis.
/// False: they do not say, and nothing is changed.
bool take_tool_of(const sequence::Sequence& sequence, const Catalog& catalog, TrackAxes& axes);

/// `line_of_command`: by RehearsedEvent::command of program `slot`, which line of its text that is. A pass of
/// a run counts how often its line was begun before.
drawing::ToolPath track_path(const Rehearsal& rehearsal, const TrackAxes& axes, int slot,
                             std::span<const int> line_of_command);

/// Of several controllers that all begin at once; the tool is the first one's, and no run has a source.
drawing::ToolPath track_path_together(std::span<const Rehearsal> all, const TrackAxes& axes);

/// For the above, of an analysed text.
std::vector<int> lines_of_commands(const ProgramReport& report, int slot);

}  // namespace hw
