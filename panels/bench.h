#pragma once
#include "gui/shell/panel_entry.h"
#include "panels/front_panel.h"

namespace hw::panels {

/// Manual control of the emulated device: its front panel, a row for each axis, and faults to provoke.
class Bench final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  static void draw_rail(gui::Frame& frame);
  static void draw_title(gui::Frame& frame, bool folded);
  void draw_parts(gui::Frame& frame);
  static void draw_trouble(gui::Frame& frame);
  static void draw_supplies(gui::Frame& frame, class Cells& cells);
  static void draw_inputs(gui::Frame& frame);
  static void draw_analog(gui::Frame& frame, int number);

  FrontPanels front_panels_;
};

}  // namespace hw::panels
