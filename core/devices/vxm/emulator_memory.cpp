// Non-volatile memory as text that a person can read and a damaged file cannot break.
#include <charconv>
#include <utility>

#include "core/devices/vxm/emulator_box.h"

namespace hw::vxm {
namespace {

template <class Visit>
void visit_pairs(Setup& s, Visit&& visit) {
  visit("motor-type", s.motor_type, 0, max_motor_type);
  visit("jog-1", s.jog_1, 0, max_speed);
  visit("jog-2", s.jog_2, min_jog_2, max_speed);
  visit("joystick-1", s.joy_1, 0, max_joystick_range);
  visit("joystick-2", s.joy_2, 0, max_joystick_range);
  visit("limit-mode", s.limit_mode, -2, 2);
  visit("pulse-every", s.pulse_every, 0, max_pulse_every);
}

template <class Visit>
void visit_values(Setup& s, Visit&& visit) {
  visit("baud", s.baud, 9, 38);
  visit("mode", s.mode, 0, 255);
  visit("dead-zone", s.dead_zone, 20, 100);
  visit("pulse-width", s.pulse_width, 1, 255);
  visit("inputs", s.inputs, 0, 255);
  visit("backlash", s.backlash, 0, max_backlash);
  visit("limit-report", s.limit_report, 0, max_limit_report);
  visit("associated", s.pma, 0, 255);
}

std::string_view trim(std::string_view text) {
  const auto from = text.find_first_not_of(" \t\r");
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

/// Takes a number off the front of `text`.
bool take_number(std::string_view& text, int& number, int min, int max) {
  text = trim(text);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || value < min || value > max) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  number = value;
  return true;
}

bool load_program(std::string_view text, Program& program) {
  program.clear();
  Reader reader;
  Command group;
  bool in_group = false, whole = true;
  for (const char c : std::string(text) + ",")
    for (const Reading& r : reader.feed(c)) {
      if (r.kind == Reading::Kind::letter && r.letter == '(') {
        group = Command(Op::group, 0, 0), in_group = true;
      } else if (r.kind == Reading::Kind::letter && r.letter == ')') {
        whole = in_group && program.add(group) && whole;
        in_group = false;
      } else if (r.kind == Reading::Kind::word && is_stored(r.head)) {
        const auto what = meaning(r, 0, true);
        const Command* command = std::get_if<Command>(&what);
        if (command == nullptr || (in_group && !is_index(command->op))) {
          whole = false;
        } else if (in_group) {
          group.parts.push_back(*command);
        } else {
          whole = program.add(*command) && whole;
        }
      } else {
        whole = false;
      }
    }
  return whole;
}

}  // namespace

std::string Box::saved_text() const {
  std::string text;
  Setup setup = saved_.setup;
  visit_pairs(setup, [&](std::string_view name, const std::array<int, 2>& v, int, int) {
    text += std::string(name) + " = " + std::to_string(v[0]) + " " + std::to_string(v[1]) + "\n";
  });
  text += "full-jog-power = " + std::to_string(int{setup.full_jog_power[0]}) + " " +
          std::to_string(int{setup.full_jog_power[1]}) + "\n";
  visit_values(setup, [&](std::string_view name, int v, int, int) {
    text += std::string(name) + " = " + std::to_string(v) + "\n";
  });
  text += "associated-except = " + std::to_string(int{setup.pma_except}) + "\n";
  for (int i = 0; i < program_count; ++i) {
    text += "program-" + std::to_string(i) + " =";
    for (const Command& c : saved_.programs[static_cast<std::size_t>(i)].commands())
      text += (text.back() == '=' ? " " : ", ") + listing_of(c);
    text += "\n";
  }
  return text;
}

std::string Box::load_line(std::string_view line) {
  const auto equals = line.find('=');
  const std::string_view name = trim(line.substr(0, equals));
  if (equals == std::string_view::npos) return "is not a setting";
  std::string_view value = line.substr(equals + 1);
  bool known = false, good = false;
  visit_pairs(saved_.setup, [&](std::string_view n, std::array<int, 2>& v, int min, int max) {
    if (n != name) return;
    std::array<int, 2> read{};
    known = true;
    good = take_number(value, read[0], min, max) && take_number(value, read[1], min, max);
    if (good) v = read;
  });
  visit_values(saved_.setup, [&](std::string_view n, int& v, int min, int max) {
    if (n != name) return;
    known = true, good = take_number(value, v, min, max);
  });
  int a = 0, b = 0;
  if (name == "full-jog-power") {
    known = true, good = take_number(value, a, 0, 1) && take_number(value, b, 0, 1);
    if (good) saved_.setup.full_jog_power = {a != 0, b != 0};
  } else if (name == "associated-except") {
    known = true, good = take_number(value, a, 0, 1);
    if (good) saved_.setup.pma_except = a != 0;
  } else if (name.substr(0, 8) == "program-" && name.size() == 9 && name[8] >= '0' && name[8] <= '4') {
    return load_program(value, saved_.programs[static_cast<std::size_t>(name[8] - '0')])
               ? ""
               : "contains unknown commands; the others are kept";
  }
  if (!known) return "is not a setting of a VXM";
  if (good && !trim(value).empty()) good = false;
  return good ? "" : "contains a value that is out of range";
}

void Box::take_saved() {
  saved_.setup.mode |= mode_always;
  if (saved_.setup.baud != 19 && saved_.setup.baud != 38) saved_.setup.baud = 9;
  reset();
}

}  // namespace hw::vxm
