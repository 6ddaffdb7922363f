#pragma once
// The texts that the controller sends (V20 to V31).
#include <cstdint>
#include <string>

#include "core/devices/vxm/program.h"

namespace hw::vxm {

/// A position register: 24 bits, two's complement (V21).
[[nodiscard]] std::int32_t wrap_position(std::int64_t steps);
/// "-0001200"
[[nodiscard]] std::string position_text(std::int32_t position);
[[nodiscard]] std::string position_reply(std::int32_t position);
/// "7<cr>"
[[nodiscard]] std::string number_reply(std::int64_t number);
/// "X+0000201<cr>"
[[nodiscard]] std::string digitize_line(char letter, std::int32_t position);
/// `lst`: a line with number and free bytes, then each command. Analog speeds are shown as `analog` gives
/// them now (App. I).
[[nodiscard]] std::string program_listing(int number, const Program& program, int analog);
/// One command as `lst` and the hold report print it.
[[nodiscard]] std::string shown(const Command& command, int analog);

}  // namespace hw::vxm
