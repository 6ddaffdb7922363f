#pragma once
// Drags a row of a list to a place before or after another row.
#include <cstddef>
#include <optional>

#include "gui/widgets/touch.h"

namespace hw::panels {

class RowDrag {
 public:
  struct Drop {
    std::size_t from = 0, to = 0;
    bool behind = false;  ///< after `to`; else before it
  };
  /// Call for each row drawn, in order.
  void see(gui::Ui& ui, std::size_t row, const gui::Touch& touch);
  /// Call after all rows. Draws the insertion mark. Returns the row dropped in this frame.
  std::optional<Drop> finish(gui::Ui& ui);
  /// Whether a row is being dragged; ignore clicks then.
  [[nodiscard]] bool carries() const { return carried_.has_value(); }

 private:
  std::optional<std::size_t> carried_;
  std::optional<Drop> over_;
  ImVec2 taken_at_{};
  gui::Rect over_rect_{};
};

}  // namespace hw::panels
