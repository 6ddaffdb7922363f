// Commands as `lst` writes them, and their cost in program memory.
#include <fmt/core.h>

#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {

std::string canonical(const TextCommand& c) {
  if (c.flaw == Flaw::unknown) return c.name;
  const char* sign = c.minus ? "-" : "";
  const char* full = c.full_power ? "A" : "";
  const auto motor = int{c.motor};
  switch (c.verb) {
    case Verb::index_by:
    case Verb::home: return fmt::format("I{}M{}{}", motor, sign, c.value);
    case Verb::index_to:
    case Verb::zero_here: return fmt::format("IA{}M{}{}", motor, sign, c.value);
    case Verb::speed:
    case Verb::speed_analog: return fmt::format("S{}{}M{}{}", full, motor, sign, c.value);
    case Verb::acceleration: return fmt::format("A{}M{}", motor, c.value);
    case Verb::loop_forever: return "L0";
    case Verb::marker_set: return c.minus ? "L-0" : "LM0";
    case Verb::marker_reset: return "LM-0";
    case Verb::loop: return fmt::format("L{}{}", sign, c.value);
    case Verb::loop_always: return fmt::format("LA{}{}", sign, c.value);
    case Verb::loop_reverse: return fmt::format("LM{}{}", sign, c.value);
    case Verb::jump: return fmt::format("J{}", c.value);
    case Verb::jump_return:
    case Verb::jump_pick: return fmt::format("JM{}{}", sign, c.value);
    case Verb::pause: return fmt::format("P{}{}", sign, c.value);
    case Verb::pause_output: return fmt::format("PA{}{}", sign, c.value);
    case Verb::user: return fmt::format("U{}", c.value);
    case Verb::pair_begins: return "(";
    case Verb::pair_ends: return ")";
    case Verb::slave_begins: return "[";
    case Verb::slave_ends: return "]";
    case Verb::select:
    case Verb::empty: return fmt::format("PM{}{}", sign, c.value);
    case Verb::ask_selected: return "PM";
    case Verb::associate: return fmt::format("PMA{}{}", sign, c.value);
    case Verb::ask_associate: return "PMA";
    case Verb::set:
      if (c.name == "Bx" || c.name == "O") return fmt::format("{}{}", c.name[0], c.value);
      return fmt::format("set{}{}{}", c.name, sign, c.value);
    case Verb::get: return c.name == "Bx" || c.name == "O" ? c.name.substr(0, 1) : "get" + c.name;
    case Verb::letter: return std::string(1, c.letter);
    case Verb::word: return c.name;
  }
  return {};
}

// The command's text before motor and number, as the table of costs has it.
static std::string_view head_of(const TextCommand& c) {
  switch (c.verb) {
    case Verb::index_by:
    case Verb::home: return "I";
    case Verb::index_to:
    case Verb::zero_here: return "IA";
    case Verb::speed:
    case Verb::speed_analog: return c.full_power ? "SA" : "S";
    case Verb::acceleration: return "A";
    case Verb::loop: return "L";
    case Verb::loop_always: return "LA";
    case Verb::marker_set:
    case Verb::marker_reset:
    case Verb::loop_reverse: return "LM";
    case Verb::jump:
    case Verb::jump_return:
    case Verb::jump_pick: return "J";
    case Verb::pause: return "P";
    case Verb::pause_output: return "PA";
    case Verb::user: return "U";
    default: return {};
  }
}

int program_cost(const TextCommand& c) {
  if (c.verb == Verb::loop_forever || (c.verb == Verb::marker_set && c.minus)) return endless_loop_bytes;
  if (c.verb == Verb::user && c.value == 91) return u91_bytes;
  if (c.verb == Verb::pair_begins) return pair_bytes;
  const std::string_view head = head_of(c);
  for (const StoredForm& form : stored_forms)
    if (form.head == head) return form.bytes;
  return 0;
}

}  // namespace hw::vxm
