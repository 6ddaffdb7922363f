#pragma once
// What hangs on an axis where no catalog knows it: told as units a step, by its drive, or by two points that
// somebody has measured. Ids: `dro/unit/own/X/step`, `/name`, `/full`, `/micro`, `/gear`, `/travel`,
// `/drive`,
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

  /// True: `own` is another one now.
  bool draw(gui::Frame& frame, AxisId axis, OwnUnit& own);

 private:
  struct Point {
    gui::NumberField place;
    std::optional<Steps> steps;  ///< where the axis stood when it was measured
  };
  bool draw_step(gui::Frame& frame, AxisId axis, OwnUnit& own);
  bool draw_drive(gui::Frame& frame, AxisId axis, OwnUnit& own);
  bool draw_points(gui::Frame& frame, AxisId axis, OwnUnit& own);
  void draw_point(gui::Frame& frame, AxisId axis, Point& point, std::string_view id, float x);

  gui::NumberField step_, full_, micro_, gear_, travel_;
  std::array<Point, 2> points_;
};

}  // namespace hw::panels
