#include "panels/blocks/row_drag.h"

#include <cmath>
#include <utility>

namespace hw::panels {

using namespace gui;

constexpr float carried_from_px = 6;

void RowDrag::see(Ui& ui, std::size_t row, const Touch& t) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (t.started) taken_at_ = mouse;
  if (t.held && ImGui::IsMouseDown(0) && std::fabs(mouse.y - taken_at_.y) > ui.px(carried_from_px))
    carried_ = row;
  // The gap below a row belongs to the row.
  if (!carried_ || mouse.y < t.rect.min.y || mouse.y >= t.rect.max.y + ui.px(4)) return;
  over_ = Drop{*carried_, row, mouse.y > t.rect.centre().y};
  over_rect_ = t.rect;
}

std::optional<RowDrag::Drop> RowDrag::finish(Ui& ui) {
  if (ui.cancelled()) carried_.reset();
  if (!carried_) {
    over_.reset();
    return std::nullopt;
  }
  if (over_ && over_->to != *carried_) {
    const float y = over_->behind ? over_rect_.max.y : over_rect_.min.y - ui.px(4);
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(over_rect_.min.x, y + ui.px(1)),
                                              ImVec2(over_rect_.max.x, y + ui.px(3)), ui[Tone::ink]);
  }
  if (ImGui::IsMouseDown(0)) return std::nullopt;
  carried_.reset();
  const std::optional<Drop> dropped = std::exchange(over_, std::nullopt);
  return dropped && dropped->to != dropped->from ? dropped : std::nullopt;
}

}  // namespace hw::panels
