#pragma once
#include "gui/panel.h"
#include "gui/units_format.h"
#include "gui/widgets/digits.h"
#include "panels/axis_menu.h"

namespace hw::panels {

/// Where each axis stands, what it does, and how far that is to be believed.
class Position final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void draw_title(gui::Frame& frame);
  void draw_column(gui::Frame& frame);
  void draw_strip(gui::Frame& frame);
  void draw_axis(gui::Frame& frame, AxisId axis, float width, gui::Face face, bool in_strip);
  void draw_digits(gui::Frame& frame, AxisId axis, float width, gui::Face face);
  void draw_captions(gui::Frame& frame, AxisId axis, ImVec2 at, float width);
  static gui::NumberText where_to(const gui::Frame& frame, AxisId axis, bool whole);

  AxisMenu menu_;
};

}  // namespace hw::panels
