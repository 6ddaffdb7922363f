#pragma once
// A row of a list that is taken hold of, carried, and let go before or behind another.
#include <cstddef>
#include <optional>

#include "gui/widgets/touch.h"

namespace hw::panels {

class RowDrag {
 public:
  struct Drop {
    std::size_t from = 0, to = 0;
    bool behind = false;  ///< of `to`; else in front of it
  };
  /// Of each row that is drawn, in their order.
  void see(gui::Ui& ui, std::size_t row, const gui::Touch& touch);
  /// Behind all rows: draws where it would come; what was let go in this frame.
  std::optional<Drop> finish(gui::Ui& ui);
  /// A row is under way: a click is none.
  [[nodiscard]] bool carries() const { return carried_.has_value(); }

 private:
  std::optional<std::size_t> carried_;
  std::optional<Drop> over_;
  ImVec2 taken_at_{};
  gui::Rect over_rect_{};
};

}  // namespace hw::panels
