#pragma once
// The board's side of bus cycles: a 4 KiB window in which each access may have an effect. Synchronous, at the
// time of the emulator's last advance_to(). The host's side is in core/link/window.h.
#include <cstdint>
#include <optional>

namespace hw {

inline constexpr std::uint16_t bus_window_bytes = 4096;

class BusTarget {
 public:
  virtual ~BusTarget() = default;

  /// Hardware cycles of the bus. `offset` is from the board's base; 16-bit cycles are big-endian at even
  /// offsets (an odd one is rounded down, as the bus has no address line 0).
  virtual std::uint8_t read8(std::uint16_t offset) = 0;
  virtual std::uint16_t read16(std::uint16_t offset) = 0;
  virtual void write8(std::uint16_t offset, std::uint8_t value) = 0;
  virtual void write16(std::uint16_t offset, std::uint16_t value) = 0;

  /// The interrupt vector; none while the board does not interrupt.
  [[nodiscard]] virtual std::optional<std::uint8_t> interrupt() const = 0;
  /// The host has fetched the vector: the board releases the interrupt line.
  virtual void acknowledge() = 0;
};

/// One host access of `width` 1, 2 or 4 bytes; 32 bits are two cycles of 16, high half first. Offsets wrap at
/// the end of the window. Returns the value read, 0 for a write.
std::uint32_t bus_cycle(BusTarget& board, bool write, std::uint8_t width, std::uint16_t offset,
                        std::uint32_t value = 0);

}  // namespace hw
