#pragma once
// What a path canvas is asked to show.
#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "core/drawing/tool_path.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// The axes that a path is seen in.
struct PathAxes {
  AxisId right{0}, up{1};
  std::optional<AxisId> third = {};  ///< in perspective then; none: two axes as they are
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
  int lit = -1;                 ///< runs of this source stand out
  drawing::Box3 table = {};     ///< where the tool gets; empty: not known
  std::string_view words = {};  ///< what it comes to, for scripts; empty: how it is looked at
  std::optional<drawing::Point3> wanted_at = {};  ///< where the tool is asked to go from where it is
  std::optional<OwnPlane> own = {};               ///< none: the axes are this controller's
};

drawing::Point3 place_of(const gui::Tab& tab, const std::array<Steps, max_axes>& position,
                         const PathAxes& axes);
/// None: not known.
std::optional<drawing::Point3> place_now(const gui::Frame& frame, const PathAxes& axes);
std::optional<drawing::Point3> place_now(const gui::Frame& frame, const PathSubject& subject);
/// Their positions count in one unit, so that a circle is one.
bool one_unit(const gui::Tab& tab, const PathAxes& axes);
bool one_unit(const gui::Tab& tab, const PathSubject& subject);
std::string_view unit_name(const gui::Tab& tab, const PathSubject& subject, AxisId axis);

}  // namespace hw::panels
