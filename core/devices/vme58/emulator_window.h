#pragma once
// The memory of the window below the registers: two rings with their indexes, the axis data, the reserved
// areas. Which half of it the host may write, and what the board makes of the indexes.
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/devices/vme58/facts.h"

namespace hw::vme58 {

class Window {
 public:
  /// Cycles of the host. Offsets below the registers.
  [[nodiscard]] std::uint8_t read(std::uint16_t offset) const { return bytes_[offset]; }
  /// Ignored where the host may only read (decision M28).
  void write(std::uint16_t offset, std::uint8_t value) {
    if (offset >= at::output_put_index && offset < at::registers) bytes_[offset] = value;
  }

  /// Commands: the next character, none when the board has caught up.
  [[nodiscard]] std::optional<char> take();
  /// Replies: false when the ring is full.
  bool put(char c);
  /// Both of the host's indexes lie in the rings.
  [[nodiscard]] bool indexes_make_sense() const;

  void set_axis_value(int axis, AxisValue value, std::int32_t to);
  [[nodiscard]] std::uint16_t cell(std::uint16_t offset) const;
  void set_cell(std::uint16_t offset, std::uint16_t value);

  /// Nothing waits among the commands.
  [[nodiscard]] bool all_taken() const { return cell(at::output_put_index) == cell(at::output_get_index); }

  /// The board has taken over what the host says to its indexes: nothing waits in either ring.
  void empty_rings();

 private:
  std::array<std::uint8_t, at::registers> bytes_{};
};

}  // namespace hw::vme58
