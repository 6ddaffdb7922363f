#pragma once
#include <array>
#include <string>

#include "gui/panel.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

/// To a position, or to the home of an axis.
class GotoHome final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  struct Row {
    gui::NumberField field;
    IntentId asked = 0;   ///< the move that was sent last
    std::string refused;  ///< why the last one was not done
    Steps nearest{};      ///< offered instead, when `offers`
    bool offers = false;
  };
  void draw_title(gui::Frame& frame);
  void draw_row(gui::Frame& frame, AxisId axis);
  void draw_homes(gui::Frame& frame, AxisId axis, std::string_view why);
  void draw_refusal(gui::Frame& frame, AxisId axis);
  void go(gui::Frame& frame, AxisId axis);
  void go_to(gui::Frame& frame, AxisId axis, Steps target);
  void follow(gui::Frame& frame, AxisId axis);

  std::array<Row, max_axes> rows_;
  int mode_ = 0;
};

}  // namespace hw::panels
