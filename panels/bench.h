#pragma once
#include <array>
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
  void draw_front_panel(gui::Frame& frame);
  void draw_lamps(gui::Frame& frame, ImVec2 corner, float width, std::size_t columns);
  void draw_power(gui::Frame& frame, ImVec2 at);
  void draw_buttons(gui::Frame& frame, ImVec2 at, float width);
  void draw_trouble(gui::Frame& frame);
  void draw_axes(gui::Frame& frame);
  void draw_inputs(gui::Frame& frame);
  void release_forgotten(gui::Frame& frame);

  std::array<bool, max_axes> home_by_hand_{};  ///< home switches that are pressed here
  std::string pressed_;                        ///< the button that the mouse holds
};

}  // namespace hw::panels
