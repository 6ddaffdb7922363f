#pragma once
// The cells of a grid, row by row. All cells of a row are equally wide. The last cell ends at the panel's
// edge.
#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include <imgui.h>

#include "gui/surface/ui.h"
#include "gui/widgets/text.h"
#include "panels/measures.h"

namespace hw::panels {

class Cells {
 public:
  Cells(gui::Ui& ui, float width, int columns, float row)
      : ui_(ui),
        at_(ImGui::GetCursorScreenPos()),
        columns_(columns),
        row_(row),
        pitch_((width + between) / static_cast<float>(columns)) {}
  /// Moves the cursor to cell `n`, from 0.
  void stand(int n) {
    ImGui::SetCursorScreenPos(ImVec2(at_.x + ui_.px(std::floor(pitch_ * static_cast<float>(n % columns_))),
                                     at_.y + ui_.px(row_ * static_cast<float>(n / columns_))));
    count_ = std::max(count_, n + 1);
  }
  /// Moves the cursor to the cell after the last.
  void stand_at_next() { stand(count_); }
  [[nodiscard]] float cell() const { return std::floor(pitch_) - between; }
  /// Moves the cursor below all cells.
  void end() {
    const int rows = (count_ + columns_ - 1) / columns_;
    ImGui::SetCursorScreenPos(ImVec2(at_.x, at_.y + ui_.px(row_ * static_cast<float>(rows))));
  }

 private:
  gui::Ui& ui_;
  ImVec2 at_;
  int columns_, count_ = 0;
  float row_, pitch_;
};

/// Whether each name fits into a cell when `columns` cells share `width`, with `around` logical pixels beside
/// it.
template <class Named>
bool fit_in_cells(const gui::Ui& ui, float width, int columns, std::span<const Named> names, float around) {
  const float cell = std::floor((width + between) / static_cast<float>(columns)) - between;
  return std::all_of(names.begin(), names.end(), [&](const Named& named) {
    return text_width(ui, gui::Face::body_bold, named.name) + ui.px(around) <= ui.px(cell);
  });
}

}  // namespace hw::panels
