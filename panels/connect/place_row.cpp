#include "panels/connect/place_row.h"

#include <algorithm>

#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "panels/measures.h"

namespace hw::panels {

using namespace gui;

float draw_place_row(Ui& ui, const PlaceRow& row, float width, float buttons) {
  constexpr float least = 56, title_middle = 19, facts_top = 29;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = at.x + ui.px(place_mark), right = at.x + ui.px(width - buttons - between);
  const float facts_px = wrapped_height(ui, Face::body, row.facts, right - left);
  const float height = std::max(ui.px(least), ui.px(facts_top) + facts_px + ui.px(6));
  if (row.chosen) draw_across(ui, at.y, at.y + height, ui[Tone::well], ui[Tone::ink]);
  draw_icon(ImGui::GetWindowDrawList(), row.mark, ImVec2(at.x + ui.px(6), at.y + ui.px(title_middle)),
            ui.px(12), ui[row.tone]);
  const float state =
      row.state.empty() ? 0 : std::ceil(text_width(ui, Face::body_bold, row.state)) + ui.px(12);
  draw_text_line(ui, left, right - state, at.y + ui.px(title_middle), Face::title_bold, ui[Tone::ink],
                 row.title);
  if (state > 0)
    draw_text_line(ui, right - state + ui.px(12), right + 1, at.y + ui.px(title_middle), Face::body_bold,
                   ui[row.state_tone], row.state);
  ImGui::SetCursorScreenPos(ImVec2(left, at.y + ui.px(facts_top)));
  wrapped(ui, Face::body, Tone::ink2, row.facts, (right - left) / ui.scale);
  ImGui::SetCursorScreenPos(at);
  return height;
}

RowButtons::RowButtons(Ui& ui, float width)
    : ui_(ui), at_(ImGui::GetCursorScreenPos()), right_(at_.x + ui.px(width)) {}

void RowButtons::stand(float width) {
  right_ -= ui_.px(width);
  ImGui::SetCursorScreenPos(ImVec2(right_, at_.y + ui_.px(12)));
  right_ -= ui_.px(between);
}

bool RowButtons::press(std::string_view id, std::string_view label, float width, ButtonOptions options) {
  options.width = width;
  stand(width);
  return button(ui_, id, label, options).clicked;
}

std::string_view short_place(std::string_view where) {
  constexpr std::string_view folder = "/dev/";
  return where.starts_with(folder) ? where.substr(folder.size()) : where;
}

}  // namespace hw::panels
