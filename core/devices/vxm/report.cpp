#include "core/devices/vxm/report.h"

#include <cstdio>
#include <cstdlib>

namespace hw::vxm {

std::int32_t wrap_position(std::int64_t steps) {
  constexpr std::int64_t span = std::int64_t{1} << 24;
  const std::int64_t low = ((steps - position_min) % span + span) % span;
  return static_cast<std::int32_t>(low + position_min);
}

std::string position_text(std::int32_t position) {
  char text[16];
  std::snprintf(text, sizeof text, "%c%07ld", position < 0 ? '-' : '+', std::labs(position));
  return text;
}

std::string position_reply(std::int32_t position) { return position_text(position) + '\r'; }

std::string number_reply(std::int64_t number) { return std::to_string(number) + '\r'; }

std::string digitize_line(char letter, std::int32_t position) { return letter + position_reply(position); }

std::string shown(const Command& command, int analog) {
  const bool full = command.op == Op::analog_speed_full;
  if (!full && command.op != Op::analog_speed) return listing_of(command);
  const AnalogRange* range = find_analog_range(command.value);
  if (range == nullptr) return listing_of(command);
  return listing_of(Command(full ? Op::speed_full : Op::speed, command.motor, analog_speed(*range, analog)));
}

std::string program_listing(int number, const Program& program, int analog) {
  std::string text = "PM" + std::to_string(number) + " M" + std::to_string(program.free()) + '\r';
  for (const Command& command : program.commands()) text += shown(command, analog) + '\r';
  return text;
}

}  // namespace hw::vxm
