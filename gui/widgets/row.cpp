#include "gui/widgets/row.h"

#include <imgui_internal.h>

#include "gui/widgets/text.h"

namespace hw::gui {

Columns::Columns(const Ui& ui, std::span<const Column> columns, float left_px, float right_px)
    : columns_(columns), left_(left_px), right_(right_px), scale_(ui.scale) {
  float fixed = 0;
  int sharing = 0;
  for (const Column& c : columns) {
    fixed += ui.px(c.width);
    sharing += c.width == 0;
  }
  if (sharing) share_ = std::max(0.0f, right_px - left_px - fixed) / static_cast<float>(sharing);
}

Rect Columns::cell(std::size_t column, const Rect& row) const {
  float x = left_;
  const auto width = [&](const Column& c) {
    return c.width == 0 ? share_ : std::floor(c.width * scale_ + 0.5f);
  };
  for (std::size_t i = 0; i < column; ++i) x += width(columns_[i]);
  return {ImVec2(std::floor(x), row.min.y),
          ImVec2(std::floor(std::min(right_, x + width(columns_[column]))), row.max.y)};
}

void Columns::text(const Ui& ui, std::size_t column, const Rect& row, Face face, ImU32 colour,
                   std::string_view s) const {
  const Rect c = cell(column, row);
  const bool last = column + 1 == columns_.size();
  const float end = c.max.x - (last ? 0 : ui.px(8));
  const float w = std::ceil(text_width(ui, face, s));
  const float x = columns_[column].right ? std::max(c.min.x, end - w) : c.min.x;
  draw_text_line(ui, x, end + 1, c.centre().y, face, colour, s);
}

void table_head(Ui& ui, const Columns& columns) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect row{at, ImVec2(at.x, at.y + ui.px(32))};
  for (std::size_t i = 0; i < columns.columns().size(); ++i)
    columns.text(ui, i, row, Face::small, ui[Tone::ink2], columns.columns()[i].title);
  ImGui::SetCursorScreenPos(ImVec2(at.x, row.max.y));
}

Touch row(Ui& ui, std::string_view id, std::string_view label, const RowOptions& o) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, h = ui.px(o.height);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->ChannelsSplit(2);
  list->ChannelsSetCurrent(1);
  Touch t;
  if (o.pressable) {
    t = touch(ui, {id, Kind::row, label, o.value, o.disabled, false, {}}, ImVec2(width, h));
    ImGui::SetItemAllowOverlap();
  } else {
    t.rect = {at, ImVec2(at.x + width, at.y + h)};
    show(ui, {id, Kind::text, label, o.value, {}, false, {}}, t.rect);
  }
  list->ChannelsSetCurrent(0);
  const ImU32 ground = o.bad                      ? ui[Tone::fault_t]
                       : o.chosen                 ? ui[Tone::sel]
                       : t.hovered && o.pressable ? ui[Tone::raised]
                                                  : 0;
  const ImU32 bar = o.bad ? ui[Tone::fault] : o.chosen ? ui[Tone::ink] : 0;
  const Rect whole = draw_across(ui, at.y, at.y + h, ground, bar);
  if (o.hairline) draw_across(ui, at.y, at.y + ui.hair(), ui[Tone::line]);
  list->ChannelsMerge();
  if (t.ring) draw_outline(ui, whole, ui[Tone::ink], 0, ui.px(2));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + h));
  return t;
}

}  // namespace hw::gui
