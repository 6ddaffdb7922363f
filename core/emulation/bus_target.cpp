#include "core/emulation/bus_target.h"

namespace hw {
namespace {

constexpr std::uint16_t offset_mask = bus_window_bytes - 1;

std::uint16_t bus_cycle16(BusTarget& board, bool write, std::uint16_t offset, std::uint16_t value) {
  offset = offset & offset_mask & ~std::uint16_t{1};
  if (!write) return board.read16(offset);
  board.write16(offset, value);
  return 0;
}

}  // namespace

std::uint32_t bus_cycle(BusTarget& board, bool write, std::uint8_t width, std::uint16_t offset,
                        std::uint32_t value) {
  if (width == 4) {
    const auto next = static_cast<std::uint16_t>(offset + 2);
    const std::uint32_t high = bus_cycle16(board, write, offset, static_cast<std::uint16_t>(value >> 16));
    return high << 16 | bus_cycle16(board, write, next, static_cast<std::uint16_t>(value));
  }
  if (width == 2) return bus_cycle16(board, write, offset, static_cast<std::uint16_t>(value));
  if (!write) return board.read8(offset & offset_mask);
  board.write8(offset & offset_mask, static_cast<std::uint8_t>(value));
  return 0;
}

}  // namespace hw
