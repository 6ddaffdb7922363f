#pragma once
// Chooses steps or real units, and the load of each axis (`dro/unit`).
#include <array>
#include <string_view>

#include "gui/shell/frame.h"
#include "panels/position/own_unit_form.h"

namespace hw::panels {

class UnitChooser {
 public:
  void draw(gui::Frame& frame);

 private:
  void draw_axis(gui::Frame& frame, std::size_t axis);
  std::array<OwnUnitForm, max_axes> own_;
};
/// The unit of positions: "mm", "pulses"; if the axes differ, the unit of most of them.
std::string_view shown_unit(const gui::Frame& frame);
/// The width, logical.
float unit_chooser_width(const gui::Frame& frame);

}  // namespace hw::panels
