#pragma once
// The memory of the window below the registers: two rings with their indexes, the axis data, the reserved
// areas. Knows which half the host may write, and how the board uses the indexes.
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/devices/vme58/facts.h"

namespace hw::vme58 {

class Window {
 public:
  /// Host cycles. `offset` must be below the registers.
  [[nodiscard]] std::uint8_t read(std::uint16_t offset) const { return bytes_[offset]; }
  /// Ignored where the host may only read (decision M28).
  void write(std::uint16_t offset, std::uint8_t value) {
    if (offset >= at::output_put_index && offset < at::registers) bytes_[offset] = value;
  }

  /// Takes the next command character; none: the board has caught up.
  [[nodiscard]] std::optional<char> take();
  /// Puts a reply character; false: the ring is full.
  bool put(char c);
  /// Both host indexes lie within the rings.
  [[nodiscard]] bool indexes_make_sense() const;

  void set_axis_value(int axis, AxisValue value, std::int32_t to);
  [[nodiscard]] std::uint16_t cell(std::uint16_t offset) const;
  void set_cell(std::uint16_t offset, std::uint16_t value);

  /// No command characters wait.
  [[nodiscard]] bool all_taken() const { return cell(at::output_put_index) == cell(at::output_get_index); }

  /// Adopts the host's indexes, so that nothing waits in either ring.
  void empty_rings();

 private:
  std::array<std::uint8_t, at::registers> bytes_{};
};

}  // namespace hw::vme58
