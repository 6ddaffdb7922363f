#pragma once
#include <vector>

#include <imgui.h>

#include "gui/panel.h"
#include "gui/units_format.h"
#include "panels/jog_speed.h"

namespace hw::panels {

/// Hold to move, tap for one step. Up to four axes: a pad; where each axis has a row with its own two
/// buttons: Stop and the steps.
class Jog final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void draw_title(gui::Frame& frame);
  void draw_hint(gui::Frame& frame);
  void draw_cross(gui::Frame& frame);
  void draw_pairs(gui::Frame& frame);
  void draw_button(gui::Frame& frame, AxisId axis, Sign sign, float x, float y, ImVec2 size);
  void draw_stop(gui::Frame& frame, float x, float y, ImVec2 size);
  void draw_steps_column(gui::Frame& frame, float x, float width, float height);
  void draw_steps_row(gui::Frame& frame, float x, float y, float width);
  [[nodiscard]] float spare_of(const gui::Frame& frame, int room, float row) const;
  void draw_step(gui::Frame& frame, const gui::JogStep& step, std::string_view label, float width);
  [[nodiscard]] bool labels_fit(const gui::Frame& frame, float width) const;
  /// What a step is called where `room` (0: least) words have room.
  [[nodiscard]] std::string_view label_of(const gui::JogStep& step, int room) const;
  void follow_unit(gui::Frame& frame);

  JogSpeed speed_;
  std::vector<gui::JogStep> steps_;
  gui::DisplayUnit steps_unit_;
  int steps_many_ = 0;
  ImVec2 origin_{};
};

}  // namespace hw::panels
