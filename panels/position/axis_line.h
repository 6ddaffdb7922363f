#pragma once
// Draws the row of a device of a bus, or of an axis of a controller with more than four: name and position,
// below them the state, at the right two jog buttons. A press on the row chooses the device or axis.
#include <string_view>

#include "gui/model/axis_look.h"
#include "gui/model/tab.h"
#include "gui/surface/ui.h"
#include "gui/widgets/touch.h"

namespace hw::panels {

inline constexpr float axis_line_height = 44;

struct AxisLine {
  std::string_view id;     ///< of the row: "bus/03", "axis/X"
  std::string_view name;   ///< of its widgets: "03" in `dro/03/position`
  std::string_view label;  ///< the user's name
  std::string_view tip;    ///< of the number
  gui::State state;
  bool chosen = false;
  gui::Face face = gui::Face::digits26;  ///< of the number: see axis_line_face
};

/// The face in which a number, `number_px` wide at digits26, does not touch the name in a line of that width.
gui::Face axis_line_face(const gui::Ui& ui, float number_px, float width);

struct AxisLineTouch {
  bool pressed = false;
  gui::Touch number;
  gui::Rect aside;  ///< free part of the second line, from the state word to the end of the number
};

/// Draws at the cursor, `width` logical pixels wide, and leaves it below the row.
AxisLineTouch draw_axis_line(gui::Ui& ui, gui::Tab& tab, AxisId axis, const AxisLine& line, float width);

}  // namespace hw::panels
