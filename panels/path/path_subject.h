#pragma once
// Describes the content of a path canvas.
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
  std::optional<AxisId> third = {};  ///< shown in perspective; nullopt: two axes in plan
  bool over_time = false;            ///< seconds go to the right, and `right` is not shown
  bool operator==(const PathAxes&) const = default;
};

/// The plane of a drawing by several controllers: all axes have one unit, and only the position of the
/// machine is shown.
struct OwnPlane {
  std::string_view unit;
  std::optional<drawing::Point3> here;  ///< none: unknown
  std::string_view here_words;
};

/// All lengths are in the units of the axes.
struct PathSubject {
  std::shared_ptr<const drawing::ToolPath> path;            ///< null: none
  std::string_view none;                                    ///< sentence shown without a path
  std::shared_ptr<const drawing::ToolPath> commanded = {};  ///< the intended path, drawn under `path`
  PathAxes axes = {};
  int lit = -1;                      ///< highlights runs of this source
  int lit_count = 1;                 ///< number of successive sources highlighted
  std::optional<int> lit_pass = {};  ///< ToolPath::Run::pass of the highlighted runs; none: all
  /// Whether the highlighted runs are being executed: runs before the reached place are done, runs after it
  /// are still to do.
  bool at_work = false;
  std::optional<bool> tool_on =
      {};  ///< as reported by the controller; nullopt: no signal switches the tool, or unknown
  drawing::Box3 table = {};                       ///< range of the tool; empty: unknown
  std::string_view words = {};                    ///< totals, for scripts; empty: the view
  std::optional<drawing::Point3> wanted_at = {};  ///< requested position of the tool
  std::optional<OwnPlane> own = {};               ///< nullopt: the axes are those of the machine
  bool origin = false;                            ///< marks the origin and always shows it
};

/// The quantity along a direction of a path view: an axis of a controller (on a bus, of any controller), or
/// time.
struct Direction {
  gui::Tab* tab = nullptr;  ///< tab of the axis; null: time
  AxisId axis{0};           ///< index in that controller
  std::string_view name;    ///< "X", on a bus "02", "time"

  [[nodiscard]] const gui::DisplayUnit& unit() const;  ///< for time, counted in ms, it is s
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
/// The directions to the right, upwards and, if any, the third, in this order.
Directions directions_of(const gui::Frame& frame, const PathAxes& axes);
double& along(drawing::Point3& p, std::size_t direction);
inline double along(const drawing::Point3& p, std::size_t direction) {
  return along(const_cast<drawing::Point3&>(p), direction);
}

/// Zero of a time axis to the right: the start of the program, else the start of the trace.
Instant zero_of_time(const gui::Tab& tab);
/// The present place of the tool; nullopt: unknown.
std::optional<drawing::Point3> place_now(const gui::Frame& frame, const PathAxes& axes);
std::optional<drawing::Point3> place_now(const gui::Frame& frame, const PathSubject& subject);
/// Whether the tool is on, as reported by the controllers that switch it by an output or lower it by an axis;
/// nullopt: always on, or not reported.
std::optional<bool> tool_on_now(const TrackAxes& tool, const Snapshot& switching, const Snapshot& lowering,
                                int lowering_axis);
/// As above, for a path drawn from a sequence. If several controllers draw, the first of them switches the
/// tool.
std::optional<bool> tool_on_now(const gui::Frame& frame, const TrackAxes& tool,
                                const sequence::Sequence& drawn);
/// Whether the positions have one unit, so that a circle looks round.
bool one_unit(const gui::Frame& frame, const PathAxes& axes);
bool one_unit(const gui::Frame& frame, const PathSubject& subject);
std::string_view unit_name(const PathSubject& subject, const Direction& direction);

}  // namespace hw::panels
