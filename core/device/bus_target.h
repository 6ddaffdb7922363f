#pragma once
// The board's side of bus cycles: a 4 KiB window in which each access may have an effect. Synchronous, at the
// time of the emulator's last advance_to(). What a memory window is to a host is in core/link/window.h.
#include <cstdint>
#include <optional>

namespace hw {

inline constexpr std::uint16_t bus_window_bytes = 4096;

class BusTarget {
 public:
  virtual ~BusTarget() = default;

  /// Cycles of the bus as its hardware knows them. `offset` counts from the board's base; 16-bit cycles are
  /// big-endian and stand at even offsets (an odd one is rounded down, as the bus has no address line 0).
  virtual std::uint8_t read8(std::uint16_t offset) = 0;
  virtual std::uint16_t read16(std::uint16_t offset) = 0;
  virtual void write8(std::uint16_t offset, std::uint8_t value) = 0;
  virtual void write16(std::uint16_t offset, std::uint16_t value) = 0;

  /// The vector that the board would put on the bus if it were asked now; none while it does not interrupt.
  [[nodiscard]] virtual std::optional<std::uint8_t> interrupt() const = 0;
  /// The host has fetched the vector: the board lets go of the interrupt line.
  virtual void acknowledge() = 0;
};

/// One cycle of `width` 1, 2 or 4 bytes, the only way from a host's access to a board's cycles: an access of
/// 32 bits is two cycles of 16, high half first. Offsets wrap at the end of the window. Returns what was
/// read, 0 of a write.
std::uint32_t bus_cycle(BusTarget& board, bool write, std::uint8_t width, std::uint16_t offset,
                        std::uint32_t value = 0);

}  // namespace hw
