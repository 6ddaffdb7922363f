#pragma once
#include <string>

#include <imgui.h>

#include "gui/panel.h"

namespace hw::panels {

/// The emulated device by hand: its front panel, and trouble.
class Bench final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void draw_title(gui::Frame& frame);
  void draw_front_panel(gui::Frame& frame, int supply);
  void draw_lamps(gui::Frame& frame, int supply, ImVec2 corner, float width);
  void draw_power(gui::Frame& frame, int supply, ImVec2 at);
  void draw_buttons(gui::Frame& frame, int supply, ImVec2 at, float width);
  void draw_button(gui::Frame& frame, std::size_t button, float width);
  void draw_breaker(gui::Frame& frame, int supply, ImVec2 at, float width);
  void draw_trouble(gui::Frame& frame);
  void draw_axes(gui::Frame& frame);
  void draw_inputs(gui::Frame& frame);
  void release_forgotten(gui::Frame& frame);

  std::string pressed_;  ///< the button that the mouse holds
};

}  // namespace hw::panels
