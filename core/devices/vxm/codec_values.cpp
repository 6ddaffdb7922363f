// The motors and numbers that each command takes.
#include <algorithm>

#include <fmt/core.h>

#include "core/base/number_text.h"
#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

struct Range {
  std::int64_t low, high;
};

Range setup_range(const TextCommand& c) {
  if (c.name == "Bx") return {0, max_backlash};
  if (c.name == "O") return {0, max_limit_report};
  if (c.name == "D") return {0, 0};
  std::string pattern = c.name;
  for (char& letter : pattern)
    if (is_digit(letter)) letter = 'm';
  for (const SetupFact& fact : setup_facts)
    if (fact.mnemonic == pattern) return {fact.also_zero ? 0 : fact.min, fact.max};
  return {1, 0};
}

Range value_range(const TextCommand& c) {
  switch (c.verb) {
    case Verb::index_by: return {-max_index, max_index};
    case Verb::index_to: return {position_min, position_max};
    case Verb::speed: return {min_speed, max_speed};
    case Verb::acceleration: return {min_accel, max_accel};
    case Verb::loop:
    case Verb::loop_always: return c.minus ? Range{-max_loop, -min_loop} : Range{min_loop, max_loop};
    case Verb::loop_reverse: return {-3, -2};
    case Verb::jump:
    case Verb::jump_return:
    case Verb::select: return {0, program_count - 1};
    case Verb::empty:
    case Verb::jump_pick: return {-(program_count - 1), 0};
    case Verb::pause:
    case Verb::pause_output: return {-max_pause, max_pause};
    case Verb::set: return setup_range(c);
    default: return {-1'000'000'000'000, 1'000'000'000'000};
  }
}

template <class Table, class Of>
bool contains(const Table& table, std::int64_t value, Of of) {
  return std::any_of(table.begin(), table.end(), [&](const auto& row) { return of(row) == value; });
}

}  // namespace

bool possible(const TextCommand& c) {
  const auto itself = [](int n) { return n; };
  const bool has_motor =
      c.verb <= Verb::acceleration || (c.name.size() > 1 && c.name.back() == 'M' && c.name != "DM");
  if (has_motor && (c.motor < 1 || c.motor > max_motors)) return false;
  const Range range = value_range(c);
  const auto value = c.signed_value();
  if (value < range.low || value > range.high) return false;
  switch (c.verb) {
    case Verb::speed_analog:
      return contains(analog_ranges, c.value, [](const AnalogRange& r) { return r.number; });
    case Verb::user: return contains(u_commands, value, itself) || contains(slave_u_commands, value, itself);
    case Verb::associate: return c.value <= program_count - 1 || (!c.minus && c.value == pma_off);
    case Verb::pause:
    case Verb::pause_output: return !(c.minus && c.value == 0);
    case Verb::set: return c.name != "B" || contains(bauds, value, [](const Baud& b) { return b.number; });
    default: return true;
  }
}

std::string allowed_values(const TextCommand& c) {
  switch (c.verb) {
    case Verb::index_by: return fmt::format("1 to {} steps", max_index);
    case Verb::index_to: return fmt::format("{} to {} steps", position_min, position_max);
    case Verb::speed: return fmt::format("{} to {} steps/s", min_speed, max_speed);
    case Verb::speed_analog: return "a range of the manual's table, 1 to 6 or 11 to 51";
    case Verb::acceleration: return fmt::format("{} to {}", min_accel, max_accel);
    case Verb::loop:
    case Verb::loop_always: return fmt::format("{} to {} passes", min_loop, max_loop);
    case Verb::loop_reverse: return "-2 or -3";
    case Verb::jump:
    case Verb::jump_return:
    case Verb::jump_pick:
    case Verb::select:
    case Verb::empty: return fmt::format("program 0 to {}", program_count - 1);
    case Verb::pause:
    case Verb::pause_output: return fmt::format("0 to {}, or -1 to -{}", max_pause, max_pause);
    case Verb::user: return "one of the manual's U commands";
    case Verb::associate: return "0 to 4, -0 to -4, or 255";
    case Verb::set: {
      if (c.name == "B") return "9, 19 or 38";
      const Range r = setup_range(c);
      return r.low > r.high ? "nothing: there is no such setting" : fmt::format("{} to {}", r.low, r.high);
    }
    default: return {};
  }
}

}  // namespace hw::vxm
