#pragma once
// How the watchdog reaches a wire of this program when the program is gone.
#include <cstdint>
#include <string>

namespace hw {

struct WireShare {
  enum class How : std::uint8_t {
    none,
    bytes,     ///< written to `fd`
    messages,  ///< one transfer each, to the USB device that is open as `fd`
    dial,      ///< by a connection of its own to `place`
    memory     ///< cycles in the window that `fd` maps at `base`
  };
  How how = How::none;
  int fd = -1;  ///< not owned
  std::string place;
  std::uint32_t base = 0;
};

/// Who ends a held jog when this program dies.
enum class JogEnds : std::uint8_t {
  never,
  by_watchdog,
  with_program  ///< the controller is emulated in this program
};

}  // namespace hw
