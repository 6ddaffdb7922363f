#pragma once
// The menu of an axis position: copy, zero, set; the same for its encoder; travel limits; motor power. Ids:
// `dro/X/copy`, `/zero`, `/set`, `/encoder/zero`, `/encoder/set`, `/limit/-`, `/limit/-/here`,
// `/limit/-/none`, `/backlash`, `/backlash/way`, `/menu/power`.
#include <array>
#include <string>

#include "gui/shell/frame.h"
#include "gui/widgets/number_field.h"
#include "gui/widgets/touch.h"

namespace hw::panels {

class AxisMenu {
 public:
  /// Draws the menu, which a click on `digits` opens.
  void draw(gui::Frame& frame, AxisId axis, const gui::Touch& digits);

 private:
  void draw_position_rows(gui::Frame& frame, AxisId axis);
  void draw_encoder_rows(gui::Frame& frame, AxisId axis);
  void draw_limit_rows(gui::Frame& frame, AxisId axis);
  void draw_backlash_row(gui::Frame& frame, AxisId axis);

  std::string position_, encoder_;            ///< texts typed in the open menu
  std::array<gui::NumberField, 2> limits_{};  ///< -, +
  gui::NumberField backlash_;
};

}  // namespace hw::panels
