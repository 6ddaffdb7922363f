#pragma once
// All controllers of a bus, a row each: id, state, position and jog. A press chooses the one that the other
// panels act on. Whoever is in trouble stands first. Ids: `bus/03`, `dro/03/position`, `dro/03/state`,
// `jog/03/+`.
#include <string>
#include <vector>

#include "gui/bus.h"
#include "gui/panel.h"
#include "gui/tab.h"
#include "panels/axis_menu.h"

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
  void sort(const gui::Bus& bus, bool may_move);

  std::vector<gui::Tab*> order_;
  AxisMenu menu_;
};

}  // namespace hw::panels
