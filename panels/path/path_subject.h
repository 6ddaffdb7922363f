#pragma once
// The content of a path canvas.
#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "core/device/track_path.h"
#include "core/drawing/tool_path.h"
#include "gui/model/units_format.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// The axes of a path view, as indexes into the frame's catalog.
struct PathAxes {
  AxisId right{0}, up{1};
  std::optional<AxisId> third = {};  ///< shown in perspective; none: two axes in plan
  bool over_time = false;            ///< seconds go to the right, and `right` is not shown
  bool operator==(const PathAxes&) const = default;
};

/// Axes of several controllers: all in one unit, and of the machine only its position is shown.
struct OwnPlane {
  std::string_view unit;
  std::optional<drawing::Point3> here;  ///< none: unknown
  std::string_view here_words;
};

/// All of it in the units of the axes.
struct PathSubject {
  std::shared_ptr<const drawing::ToolPath> path;            ///< null: none
  std::string_view none;                                    ///< shown without a path
  std::shared_ptr<const drawing::ToolPath> commanded = {};  ///< the intended path, drawn under `path`
  PathAxes axes = {};
  int lit = -1;                      ///< highlights runs of this source ...
  int lit_count = 1;                 ///< ... and of the following ones, this many in all
  std::optional<int> lit_pass = {};  ///< ToolPath::Run::pass of the highlighted runs; none: all
  /// The highlighted runs are being executed: those before the reached place are done, those after it still
  /// to do.
  bool at_work = false;
  std::optional<bool> tool_on =
      {};                    ///< as reported by the controller; none: nothing switches the tool, or unknown
  drawing::Box3 table = {};  ///< range of the tool; empty: unknown
  std::string_view words = {};                    ///< totals, for scripts; empty: the view
  std::optional<drawing::Point3> wanted_at = {};  ///< requested position of the tool
  std::optional<OwnPlane> own = {};               ///< none: the axes are the machine's
  bool origin = false;                            ///< mark the origin and always show it
};

/// The quantity along one direction of a path view: an axis of a controller, on a bus of any of them, or
/// time.
struct Direction {
  gui::Tab* tab = nullptr;  ///< whose axis; null: time
  AxisId axis{0};           ///< index in that controller
  std::string_view name;    ///< "X", on a bus "02", "time"

  [[nodiscard]] const gui::DisplayUnit& unit() const;  ///< of time, counted in ms: s
  [[nodiscard]] const AxisState* state() const;        ///< null: time
  /// The value along this direction at these axis positions.
  [[nodiscard]] double place(const std::array<Steps, max_axes>& position) const;
  /// "X 3.000 mm"
  [[nodiscard]] std::string words(double units) const;
};
struct Directions {
  std::array<Direction, 3> all;
  std::size_t count = 0;
  [[nodiscard]] const Direction* begin() const { return all.data(); }
  [[nodiscard]] const Direction* end() const { return all.data() + count; }
};
/// To the right, upwards and optionally the third, in this order.
Directions directions_of(const gui::Frame& frame, const PathAxes& axes);
double& along(drawing::Point3& p, std::size_t direction);
inline double along(const drawing::Point3& p, std::size_t direction) {
  return along(const_cast<drawing::Point3&>(p), direction);
}

/// Zero of a time axis to the right: the start of the program, else the start of the trace.
Instant zero_of_time(const gui::Tab& tab);
/// None: unknown.
std::optional<drawing::Point3> place_now(const gui::Frame& frame, const PathAxes& axes);
std::optional<drawing::Point3> place_now(const gui::Frame& frame, const PathSubject& subject);
/// Whether the tool is on, as reported by the controllers that switch it by an output or lower it by an axis;
/// none: always on, or not reported.
std::optional<bool> tool_on_now(const TrackAxes& tool, const Snapshot& switching, const Snapshot& lowering,
                                int lowering_axis);
/// Of a path drawn from a sequence, perhaps by several controllers: the first one switches the tool.
std::optional<bool> tool_on_now(const gui::Frame& frame, const TrackAxes& tool,
                                const sequence::Sequence& drawn);
/// The positions have one unit, so that a circle looks round.
bool one_unit(const gui::Frame& frame, const PathAxes& axes);
bool one_unit(const gui::Frame& frame, const PathSubject& subject);
std::string_view unit_name(const PathSubject& subject, const Direction& direction);

}  // namespace hw::panels
