#pragma once
// Draws an analog input as name, bar and number.
#include "gui/shell/frame.h"

namespace hw::panels {

inline constexpr float analog_bar_height = 28;
/// Draws at ImGui's cursor and polls the input while it is visible. `number` is the maker's, from 1. `id` is
/// that of the bar.
void draw_analog_bar(gui::Frame& frame, std::string_view id, int number, float width);

}  // namespace hw::panels
