#pragma once
// Shows the numbered variables of the controller's programs: live and editable, with a mark at stored
// variables, and a line that accepts the maker's notation. Ids: `var/53`, `var/command`, `var/set`.
#include <string>
#include <utility>
#include <vector>

#include "gui/shell/panel_entry.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

class Variables final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void draw_grid(gui::Frame& frame, float width);
  void draw_part(gui::Frame& frame, int first, int end, int columns, float width);
  void draw_cell(gui::Frame& frame, int number, float width);
  void draw_command(gui::Frame& frame);
  void set(gui::Frame& frame);

  std::vector<gui::NumberField> fields_;
  std::string command_;
};

/// Reads number and value from "V53=-3200", "V[53] = -3200" or "53=-3200".
Result<std::pair<int, std::int64_t>> parse_assignment(std::string_view text, const VariableFacts& facts);

}  // namespace hw::panels
