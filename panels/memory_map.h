#pragma once
// Shows the memory window of a controller, as last read by the console: registers with their bits, rings, the
// data area of each axis. Opening it reads no register that is cleared by reading. Ids: `register/0xFE3`,
// `register/0xFE3/bits`, `register/0xFE3/changed`, `ring/Commands`, `ring/Commands/text`.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <imgui.h>

#include "gui/shell/panel_entry.h"

namespace hw::panels {

class MemoryMap final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  /// The last value of a cell, to mark changes.
  struct Memory {
    std::uint32_t value = 0;
    bool known = false;
    double changed_at_s = -1e9;
  };
  void follow(const gui::Frame& frame);
  void draw_column(gui::Frame& frame, bool of_axes, float width);
  void draw_register(gui::Frame& frame, std::size_t cell, float width);
  void draw_value(gui::Frame& frame, std::size_t cell, float width);
  void draw_head(gui::Frame& frame, std::size_t cell, ImVec2 at, float width, float middle);
  void draw_rings(gui::Frame& frame, float width);
  [[nodiscard]] bool fresh(const gui::Frame& frame, const MemoryCell& cell) const;
  [[nodiscard]] bool marked(const gui::Frame& frame, std::size_t cell) const;

  std::vector<Memory> cells_;
};

/// The names of the set bits: "Initialized, Done", or "none". Writes into `buffer`.
std::string_view set_bits(std::span<char> buffer, const MemoryCell& cell, std::uint32_t value);
/// The value as a number, signed if the cell is.
std::int64_t number_of(const MemoryCell& cell, std::uint32_t value);

}  // namespace hw::panels
