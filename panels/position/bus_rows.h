#pragma once
// All controllers of a bus, a row each: id, state, position and jog. A press chooses the controller that the
// other panels act on. Controllers in trouble are counted above, and a press shows them: rows do not change
// places. Ids: `bus/03`, `bus/trouble`, `dro/03/position`, `dro/03/state`, `jog/03/+`.
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
