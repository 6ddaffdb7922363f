#pragma once
// The menu of places saved for this controller: go there, record the present position, edit, forget. Ids:
// `places`, `places/NAME/go`, `/edit`, `/forget`, `/X` (while it is edited), `places/name`, `places/save`.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gui/shell/frame.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

class PlacesMenu {
 public:
  /// Draws the button that opens the menu, at the cursor. Returns the targets of a place when it was chosen.
  std::optional<std::vector<AxisTarget>> draw(gui::Frame& frame, float width, float height);

 private:
  [[nodiscard]] float rows(const gui::Frame& frame) const;
  std::optional<std::vector<AxisTarget>> draw_place(gui::Frame& frame, std::size_t place);
  void draw_axes(gui::Frame& frame, std::size_t place);
  void draw_save(gui::Frame& frame);
  void save(gui::Frame& frame);
  void edit(int place);

  std::string name_;  ///< typed name for the next place
  int edited_ = -1;   ///< index of the place that shows its axes; -1: none
  std::array<gui::NumberField, max_axes> fields_;
};

}  // namespace hw::panels
