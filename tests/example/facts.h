#pragma once
// The facts of the Twin, a controller for two step motors that nobody makes: an example of how one is added.
// Driver and emulator share this file and nothing else. Its wire carries lines of text. The host numbers its
// lines; the controller answers each with the same number, and ends the answer with a check sum:
//
//   17 G A 400 1000      go: axis A to 400, at 1000 steps/s      17 ok*9D0C
//   18 G C 400           there is no axis C                      18 no such axis*....
//
//   ID                   TWIN 1.0
//   ?                    starts, then for A and for B: position, state, speed, limits, how the motion ended
//   G axis place [speed] D axis distance [speed] J axis sign [speed]     move, move by, jog
//   H axis sign way      home: L to the - limit switch, H onto the home switch; the count is 0 there
//   P axis count         the present position is `count`
//   S axis  K axis       stop with the ramp, stop at once; * stops both
//   VA  VA=2000          read and write a parameter
#include <array>
#include <cstdint>
#include <string_view>

namespace hw::twin {

inline constexpr std::string_view model = "twin", axis_letters = "AB", name = "TWIN 1.0";
inline constexpr int axes = 2, baud = 115200, fields_of_axis = 5,
                     fields_of_status = 1 + axes * fields_of_axis;
inline constexpr std::int64_t position_max = 9'999'999, top_speed = 20'000;
inline constexpr int start_speed = 400;  ///< steps/s at which a motor starts and stops without a ramp
inline constexpr int minus_bit = 1, plus_bit = 2, ended_by_home = 3;  ///< of limits; of how a motion ended

struct Param {
  std::string_view mnemonic;
  int axis;
  std::int64_t minimum, maximum, factory;
};
inline constexpr std::array<Param, 4> params{{{"VA", 0, 1, top_speed, 2000},
                                              {"VB", 1, 1, top_speed, 2000},
                                              {"RA", 0, 100, 200'000, 10'000},
                                              {"RB", 1, 100, 200'000, 10'000}}};
inline constexpr int speed_param = 0, ramp_param = 2;  ///< of A; that of B is the next

/// Of all characters before the asterisk.
constexpr std::uint16_t check_sum(std::string_view text) {
  std::uint16_t sum = 0;
  for (const char c : text) sum = static_cast<std::uint16_t>(sum * 31 + static_cast<unsigned char>(c));
  return sum;
}

}  // namespace hw::twin
