#pragma once
#include "gui/shell/panel_entry.h"
#include "panels/front_panel.h"

namespace hw::panels {

/// The emulated device by hand: its front panel, and trouble.
class Bench final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void draw_title(gui::Frame& frame);
  void draw_trouble(gui::Frame& frame);
  void draw_axes(gui::Frame& frame);
  void draw_inputs(gui::Frame& frame);

  FrontPanels front_panels_;
};

}  // namespace hw::panels
