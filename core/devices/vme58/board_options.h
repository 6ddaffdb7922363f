#pragma once
// Variant, jumpers and settings of a board, as key=value options of an address. Values that the data sheet
// does not print (decisions M21, M47, M96) can be given too.
#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/devices/vme58/facts.h"
#include "core/time/clock.h"

namespace hw::vme58 {

struct BoardOptions {
  const Variant* variant = &variants[0];
  std::uint16_t outputs = factory_outputs;  ///< bit n: line n is an output
  std::string firmware = "2.24";            ///< as reported by WY
  // VL, AC and VB before any command sets them.
  std::int64_t velocity = default_velocity, acceleration = default_acceleration, base_velocity = 0;
  int contour_size = contour_entries;
  // Quirks: behaviour of some boards that is not in the data sheet (decisions M98 to M100).
  bool padded = false;        ///< numbers in replies carry blanks, sign, leading zeros
  bool oms_kk = false;        ///< KK is accepted on servo axes, without effect
  bool ignores_mail = false;  ///< mail is acknowledged and ignored
  Duration servo_update = std::chrono::microseconds(default_servo_update_us);
};

[[nodiscard]] bool is_board_option(std::string_view key);
/// "variant, jumpers ...", for a sentence.
std::string board_option_names();
/// Ignores other keys (of a transport).
Result<BoardOptions> read_board_options(const std::map<std::string, std::string>& given);

}  // namespace hw::vme58
