#pragma once
// How a board was bought, jumpered and set, as an address says it: key=value. What the data sheet does not
// print (decisions M21, M47, M96) can be told too.
#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/devices/vme58/facts.h"
#include "core/time/clock.h"

namespace hw::vme58 {

struct BoardOptions {
  const Variant* variant = &variants[0];
  std::uint16_t outputs = factory_outputs;  ///< bit n: line n is one
  std::string firmware = "2.24";            ///< as WY tells it
  // What VL, AC and VB are without a command.
  std::int64_t velocity = default_velocity, acceleration = default_acceleration, base_velocity = 0;
  int contour_size = contour_entries;
  // Quirks: habits that the data sheet does not know and some boards have (decisions M98 to M100).
  bool padded = false;        ///< numbers in replies have blanks, a sign and leading zeros
  bool oms_kk = false;        ///< KK is taken on servo axes, without effect
  bool deaf_mailbox = false;  ///< mail is acknowledged and nothing is done
  Duration servo_update = std::chrono::microseconds(default_servo_update_us);
};

[[nodiscard]] bool is_board_option(std::string_view key);
/// "variant, jumpers ...", for a sentence.
std::string board_option_names();
/// Other keys (of a transport) are left alone.
Result<BoardOptions> read_board_options(const std::map<std::string, std::string>& given);

}  // namespace hw::vme58
