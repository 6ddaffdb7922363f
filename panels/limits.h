#pragma once
#include "gui/panel.h"

namespace hw::panels {

/// Which limit switches are operated.
class Limits final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void draw_with_home(gui::Frame& frame);
  void draw_rail(gui::Frame& frame);
};

}  // namespace hw::panels
