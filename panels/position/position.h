#pragma once
#include "gui/model/units_format.h"
#include "gui/shell/panel_entry.h"
#include "gui/widgets/badge.h"
#include "gui/widgets/digits.h"
#include "panels/column.h"
#include "panels/position/axis_menu.h"
#include "panels/position/unit_chooser.h"

namespace hw::panels {

/// Shows position, state and trust of each axis, in a block at a fixed place (column.h). Captions are below
/// the number, or beside it in a low column. More than four axes are rows with jog buttons of their own.
class Position final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void draw_title(gui::Frame& frame);
  void draw_column(gui::Frame& frame);
  void draw_lines(gui::Frame& frame);
  void draw_strip(gui::Frame& frame);
  void draw_axis(gui::Frame& frame, AxisId axis, float width, gui::Face face, const LeftColumn& column);
  void draw_head(gui::Frame& frame, AxisId axis, ImVec2 at, float width_px, float height);
  gui::Touch draw_digits(gui::Frame& frame, AxisId axis, float width, gui::Face face);
  void draw_captions(gui::Frame& frame, AxisId axis, ImVec2 at, float width_px);
  void draw_about(gui::Frame& frame, AxisId axis, ImVec2 at, float room_px, bool origin_too);
  void draw_provenance(gui::Frame& frame, AxisId axis, ImVec2 at, float width_px);
  void draw_captions_beside(gui::Frame& frame, AxisId axis, ImVec2 at, float room_px);

  AxisMenu menu_;
  UnitChooser chooser_;
};

}  // namespace hw::panels
