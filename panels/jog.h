#pragma once
#include <vector>

#include <imgui.h>

#include "gui/panel.h"
#include "gui/units_format.h"

namespace hw::panels {

/// Hold to move, tap for one step.
class Jog final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void draw_title(gui::Frame& frame);
  void draw_reason(gui::Frame& frame);
  void draw_pad(gui::Frame& frame, float cell);
  void draw_button(gui::Frame& frame, AxisId axis, Sign sign, float x, float y, float cell);
  void draw_stop(gui::Frame& frame, float x, float y, float cell);
  void draw_steps_column(gui::Frame& frame, float x, float width, float height);
  void draw_steps_row(gui::Frame& frame);
  void draw_step(gui::Frame& frame, const gui::JogStep& step, float width);
  [[nodiscard]] bool labels_fit(const gui::Frame& frame, float width) const;
  [[nodiscard]] std::string_view label_of(const gui::JogStep& step) const;
  void draw_speed(gui::Frame& frame);
  void follow_unit(gui::Frame& frame);

  std::vector<gui::JogStep> steps_;
  gui::DisplayUnit steps_unit_;
  int steps_many_ = 0;
  bool short_labels_ = false;  ///< none of the labels has its unit; the title says it
  ImVec2 origin_{};
};

}  // namespace hw::panels
