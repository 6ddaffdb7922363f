#include "panels/blocks/block_sides.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "gui/surface/ui.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "panels/lines.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float palette_width = 160, side_alone = 264;
constexpr float palette_needs = 560;  ///< least width of the panel for the palette
constexpr float path_height = 240, low_path_height = 150, switch_height = 48, least_part = 120;

/// Width of text and path, if they fit beside palette and blocks.
float width_of_side(const Frame& f) {
  return f.area.width >= 960 ? 304 : f.area.width >= 760 ? side_alone : 0.0f;
}
bool shares(const Frame& f) { return width_of_side(f) == 0; }

void line_across_side(const Frame& f, float x, float y) {
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, y), ImVec2(f.ui.px(f.area.right()), y + f.ui.hair()),
                                            f.ui[Tone::line]);
}

}  // namespace

BlockSides::Columns BlockSides::columns(const Frame& f) const {
  const float all = f.area.width;
  if (all < palette_needs) return side_first_ ? Columns{0, 0, all} : Columns{0, all, 0};
  if (!shares(f)) return {palette_width, all - palette_width - width_of_side(f), width_of_side(f)};
  return side_first_ ? Columns{0, all - side_alone, side_alone}
                     : Columns{palette_width, all - palette_width, 0};
}

void BlockSides::show_list(const Frame& f) {
  if (f.area.width < palette_needs) side_first_ = false;
}

const char* BlockSides::other(const Frame& f) const {
  return !side_first_ ? "Text, path" : f.area.width >= palette_needs ? "Palette" : "Blocks";
}

static ButtonOptions look_of_switch(const Frame& f) {
  const char* tip =
      f.area.width >= palette_needs ? "Shows it beside the blocks." : "Replaces the present view.";
  return {.style = ButtonStyle::quiet, .tip = tip, .height = 40};
}

float BlockSides::switch_width(const Frame& f) const {
  return shares(f) ? button_width(f.ui, other(f), look_of_switch(f)) : 0;
}

void BlockSides::draw_switch(Frame& f) {
  if (!shares(f)) return;
  next_in_toolbar(f, 0, switch_width(f));
  if (button(f.ui, "blocks/aside", other(f), look_of_switch(f)).clicked) side_first_ = !side_first_;
}

void BlockSides::draw(Frame& f, float width, float height, const DrawPart& text, const DrawPart& path) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const auto place_path = [&](float below, float high) {
    const ImVec2 corner(ui.px(f.area.right() - width) + ui.hair(), at.y + ui.px(below));
    line_across_side(f, corner.x, corner.y);
    ImGui::SetCursorScreenPos(ImVec2(corner.x, corner.y + ui.hair()));
    path(width - 1, high - 1);
  };
  if (height >= 320) {
    const float of_path = height >= 420 ? path_height : low_path_height;
    text(width, height - of_path);
    return place_path(height - of_path, of_path);
  }
  static constexpr std::array<std::string_view, 2> names{"Text", "Path"};
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(16), at.y + ui.px(8)));
  if (const int picked = segment(ui, "blocks/side", names, path_first_ ? 1 : 0, {.cell_width = 64});
      picked >= 0)
    path_first_ = picked == 1;
  const float left = std::max(height - switch_height, least_part);
  if (path_first_) return place_path(switch_height, left);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(switch_height)));
  text(width, left);
}

}  // namespace hw::panels
