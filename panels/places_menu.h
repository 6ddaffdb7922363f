#pragma once
// The places that the user has saved of this controller: go there, record where it stands, change, forget.
// Ids: `places`, `places/NAME/go`, `/edit`, `/forget`, `/X` (while it is edited), `places/name`,
// `places/save`.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gui/shell/frame.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

class PlacesMenu {
 public:
  /// The button that opens it, at the cursor. The place to go to, when one was chosen.
  std::optional<std::vector<AxisTarget>> draw(gui::Frame& frame, float width, float height);

 private:
  [[nodiscard]] float rows(const gui::Frame& frame) const;
  std::optional<std::vector<AxisTarget>> draw_place(gui::Frame& frame, std::size_t place);
  void draw_axes(gui::Frame& frame, std::size_t place);
  void draw_save(gui::Frame& frame);
  void save(gui::Frame& frame);
  void edit(int place);

  std::string name_;  ///< typed, of the next one
  int edited_ = -1;   ///< which place shows its axes; -1: none
  std::array<gui::NumberField, max_axes> fields_;
};

}  // namespace hw::panels
