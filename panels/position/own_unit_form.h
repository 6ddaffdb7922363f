#pragma once
// The form for the load of an axis that the catalog does not know: as units per step, by its drive, or by two
// measured points. Ids: `dro/unit/own/X/step`, `/name`, `/full`, `/micro`, `/gear`, `/travel`, `/drive`,
// `/first`, `/first/here`, `/second`, `/second/here`, `/measured`.
#include <array>
#include <optional>
#include <string>

#include "core/session/profile.h"
#include "gui/shell/frame.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

class OwnUnitForm {
 public:
  static constexpr float rows = 3.6f;  ///< its height in rows of 32

  /// Returns true when the unit, or its direction, has changed.
  bool draw(gui::Frame& frame, AxisId axis, AxisProfile& profile);

 private:
  struct Point {
    gui::NumberField place;
    std::optional<Steps> steps;  ///< position of the axis when measured
  };
  bool draw_step(gui::Frame& frame, AxisId axis, OwnUnit& own);
  bool draw_drive(gui::Frame& frame, AxisId axis, OwnUnit& own);
  bool draw_points(gui::Frame& frame, AxisId axis, AxisProfile& profile);
  void draw_point(gui::Frame& frame, AxisId axis, Point& point, std::string_view id, float x);

  void forget_other_counts(bool counts);

  std::optional<bool> counts_;  ///< whether the numbers below count the encoder
  gui::NumberField step_, full_, micro_, gear_, travel_;
  std::array<Point, 2> points_;
};

}  // namespace hw::panels
