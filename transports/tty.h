#pragma once
// Terminal settings that serial ports and pseudo-terminals share.
#include <optional>

#include <termios.h>

namespace hw {

/// The kernel's constant; nullopt: not a standard rate.
std::optional<speed_t> speed_constant(int baud);
/// The rate of a constant; 0: unknown or hung up.
int baud_of(speed_t constant);
/// Sets raw mode, 8N1, no flow control, modem lines ignored, non-blocking reads.
void make_raw_8n1(termios& settings);

}  // namespace hw
