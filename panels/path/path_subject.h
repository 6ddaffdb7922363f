#pragma once
// What a path canvas is asked to show.
#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "core/drawing/tool_path.h"
#include "gui/model/units_format.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// The axes that a path is seen in, by their places in the frame's catalog.
struct PathAxes {
  AxisId right{0}, up{1};
  std::optional<AxisId> third = {};  ///< in perspective then; none: two axes as they are
  bool over_time = false;            ///< to the right go seconds, and `right` is not seen
  bool operator==(const PathAxes&) const = default;
};

/// Of axes that belong to several controllers: all is in one unit, and of the machine only its place is
/// shown.
struct OwnPlane {
  std::string_view unit;
  std::optional<drawing::Point3> here;  ///< none: not known
  std::string_view here_words;
};

/// All of it in the units of the axes.
struct PathSubject {
  std::shared_ptr<const drawing::ToolPath> path;            ///< null: none
  std::string_view none;                                    ///< said then
  std::shared_ptr<const drawing::ToolPath> commanded = {};  ///< as it was meant, under the path
  PathAxes axes = {};
  int lit = -1;                 ///< runs of this source stand out ...
  int lit_count = 1;            ///< ... and of those behind it
  drawing::Box3 table = {};     ///< where the tool gets; empty: not known
  std::string_view words = {};  ///< what it comes to, for scripts; empty: how it is looked at
  std::optional<drawing::Point3> wanted_at = {};  ///< where the tool is asked to go from where it is
  std::optional<OwnPlane> own = {};               ///< none: the axes are those of the machine
  bool origin = false;                            ///< is marked and always shown
};

/// What goes in one direction of a path: an axis of a controller, on a bus of any of them, or time.
struct Direction {
  gui::Tab* tab = nullptr;  ///< whose axis; null: time
  AxisId axis{0};           ///< as that controller has it
  std::string_view name;    ///< "X", on a bus "02", "time"

  [[nodiscard]] const gui::DisplayUnit& unit() const;  ///< of time, which is counted in ms: s
  [[nodiscard]] const AxisState* state() const;        ///< null: time
  /// Of axes that stand so.
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
/// To the right, upwards and perhaps the third, in this order.
Directions directions_of(const gui::Frame& frame, const PathAxes& axes);
double& along(drawing::Point3& p, std::size_t direction);
inline double along(const drawing::Point3& p, std::size_t direction) {
  return along(const_cast<drawing::Point3&>(p), direction);
}

/// With time to the right: when it is 0. That is when the program has begun, else where the trace begins.
Instant zero_of_time(const gui::Tab& tab);
/// None: not known.
std::optional<drawing::Point3> place_now(const gui::Frame& frame, const PathAxes& axes);
std::optional<drawing::Point3> place_now(const gui::Frame& frame, const PathSubject& subject);
/// Their positions count in one unit, so that a circle is one.
bool one_unit(const gui::Frame& frame, const PathAxes& axes);
bool one_unit(const gui::Frame& frame, const PathSubject& subject);
std::string_view unit_name(const PathSubject& subject, const Direction& direction);

}  // namespace hw::panels
