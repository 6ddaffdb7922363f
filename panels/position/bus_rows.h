#pragma once
// Draws a row for each controller of a bus: id, state, position and jog. A press on a row chooses the
// controller for the other panels. A line above counts the controllers in trouble; a press on it shows them,
// because rows do not change places. Ids: `bus/03`, `bus/trouble`, `dro/03/position`, `dro/03/state`,
// `jog/03/+`.
#include "gui/model/bus.h"
#include "gui/model/tab.h"
#include "gui/shell/panel_entry.h"
#include "panels/position/axis_menu.h"
#include "panels/position/unit_chooser.h"

namespace hw::panels {

class BusRows final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void draw_title(gui::Frame& frame);
  void draw_summary(gui::Frame& frame, float width);
  void draw_strip(gui::Frame& frame);
  void draw_rows(gui::Frame& frame, float height);
  void draw_row(gui::Frame& frame, gui::Tab& member, float width);

  AxisMenu menu_;
  UnitChooser chooser_;
};

}  // namespace hw::panels
