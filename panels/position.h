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
  struct Caption {
    gui::NumberText words;
    gui::Tone tone = gui::Tone::ink2;
  };
  static Caption about_number(gui::Frame& frame, AxisId axis);
  static void show_steps(gui::Frame& frame, AxisId axis, const gui::Rect& where);
  void draw_captions(gui::Frame& frame, AxisId axis, ImVec2 at, float width);
  void draw_captions_beside(gui::Frame& frame, AxisId axis, ImVec2 at, float room);
  static gui::NumberText where_to(const gui::Frame& frame, AxisId axis, bool whole);

  AxisMenu menu_;
};

}  // namespace hw::panels
