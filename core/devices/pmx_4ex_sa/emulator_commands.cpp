#include "core/devices/pmx_4ex_sa/emulator_commands.h"

#include <array>
#include <vector>

#include "core/devices/pmx_4ex_sa/facts.h"

namespace hw::pmx_4ex_sa {
namespace {

using arcus::Answer;
using arcus::Arguments;
using arcus::Command;
using arcus::Controller;
using arcus::number_in;
using arcus::parse_integer;
using arcus::position_in;
using arcus::Refusal;

using Args = Arguments;

/// "a:b:c" of all axes.
template <std::int64_t (Controller::*read)(int) const>
Answer of_all(Controller& c, const Args&) {
  std::string text;
  for (int a = 0; a < axes; ++a) text += (a == 0 ? "" : ":") + std::to_string((c.*read)(a));
  return text;
}

template <std::int64_t (Controller::*read)(int) const>
Answer of_axis(Controller& c, const Args& a) {
  return Answer::number((c.*read)(a.axis));
}

template <void (Controller::*act)(int)>
Answer on_axis(Controller& c, const Args& a) {
  (c.*act)(a.axis);
  return {};
}

/// "1000:-5:3": exactly `count` numbers, or none.
std::optional<std::vector<std::int64_t>> numbers(std::string_view text, std::size_t count) {
  std::vector<std::int64_t> found;
  for (;;) {
    const auto colon = text.find(':');
    const auto n = parse_integer(text.substr(0, colon));
    if (!n) return std::nullopt;
    found.push_back(*n);
    if (colon == std::string_view::npos) break;
    text.remove_prefix(colon + 1);
  }
  if (found.size() != count) return std::nullopt;
  return found;
}

// --- moves -------------------------------------------------------------------------------------------------

/// "X1000Y1000", blanks between the words allowed, each axis once.
Answer move(Controller& c, const Args& first) {
  const std::string_view letters = c.model().axis_letters;
  arcus::Targets targets;
  std::string_view text = first.value;
  std::size_t axis = static_cast<std::size_t>(first.axis);
  for (;;) {
    const auto end = std::min({text.find_first_of(letters), text.find(' '), text.size()});
    const auto value = parse_integer(text.substr(0, end));
    if (!value || targets[axis]) return Refusal::unknown;
    targets[axis] = *value;
    text.remove_prefix(std::min(text.find_first_not_of(' ', end), text.size()));
    if (text.empty()) return c.move(targets);
    const auto next = letters.find(text.front());
    if (next == std::string_view::npos) return Refusal::unknown;
    axis = next;
    text.remove_prefix(1);
  }
}

Answer abort_all(Controller& c, const Args&) {
  c.abort_all();
  return {};
}

Answer jog(Controller& c, const Args& a) { return c.jog(a.axis, a.sign); }

Answer home(Controller& c, const Args& a) {
  constexpr std::int64_t last_mode = 4;
  if (a.index > last_mode) return Refusal::bad_index;
  return c.home(a.axis, static_cast<arcus::HomeMode>(a.index), a.sign);
}

Answer target(Controller& c, const Args& a) {
  const auto value = position_in(a.value);
  return value ? c.change_target(a.axis, *value) : Refusal::unknown;
}

template <bool clockwise>
Answer circle(Controller& c, const Args& a) {
  const auto centre = numbers(a.value, 2);
  if (!centre) return Refusal::unknown;
  return c.arc((*centre)[0], (*centre)[1], clockwise, std::nullopt);
}

template <bool clockwise>
Answer arc(Controller& c, const Args& a) {
  const auto n = numbers(a.value, 4);
  if (!n || (*n)[3] <= 0) return Refusal::unknown;
  return c.arc((*n)[0], (*n)[1], clockwise, std::pair((*n)[2], (*n)[3]));
}

Answer change_speed(Controller& c, const Args& a) {
  const auto value = number_in(a.value, 1, arcus::max_speed);
  if (!value) return Refusal::unknown;
  const auto& s = c.settings();
  if (!s.on(Setting::speed_window, a.axis) || s.on(Setting::s_curve, a.axis)) return Refusal::speed;
  return c.change_speed(a.axis, *value);
}

Answer buffer_on(Controller& c, const Args&) { return c.buffer_on(); }
Answer buffer_off(Controller& c, const Args&) {
  c.buffer_off();
  return {};
}

Answer buffer_move(Controller& c, const Args& a) {
  const auto n = numbers(a.value, 4);
  if (!n || (*n)[3] < 1 || (*n)[3] > arcus::max_speed) return Refusal::unknown;
  arcus::Segment s;
  for (std::size_t i = 0; i < 3; ++i) {
    if ((*n)[i] < arcus::position_min || (*n)[i] > arcus::position_max) return Refusal::unknown;
    s.to[i] = (*n)[i];
  }
  s.speed = (*n)[3];
  return c.buffer_move(s);
}

// --- positions and status ----------------------------------------------------------------------------------

Answer set_position(Controller& c, const Args& a) {
  const auto value = position_in(a.value);
  return value ? c.set_position(a.axis, *value) : Refusal::unknown;
}

Answer set_encoder(Controller& c, const Args& a) {
  const auto value = position_in(a.value);
  return value ? c.set_encoder(a.axis, *value) : Refusal::unknown;
}

/// X:Y:Z:U:enabled:start:end:available:mode (decision AMB-016).
Answer status(Controller& c, const Args& a) {
  std::string text = of_all<&Controller::status>(c, a).text;
  const arcus::MoveBuffer& b = c.buffer();
  for (const int field : {b.on ? 1 : 0, b.start, b.end, c.buffer_free(), c.incremental() ? 1 : 0})
    text += ":" + std::to_string(field);
  return text;
}

Answer loop_state(Controller& c, const Args& a) {
  return Answer::number(static_cast<std::int64_t>(c.loop_state(a.axis)));
}

// --- inputs, outputs, latches, sync ------------------------------------------------------------------------

Answer analog(Controller& c, const Args& a) {
  if (a.index < 1 || a.index > analog_inputs) return Refusal::bad_index;
  return Answer::number(c.analog(static_cast<int>(a.index)));
}

Answer enable(Controller& c, const Args& a) {
  if (a.index < 1 || a.index > enables) return Refusal::bad_index;
  return Answer::number(c.enables() >> (a.index - 1) & 1);
}

Answer set_enable(Controller& c, const Args& a) {
  const auto value = parse_integer(a.value);
  if (!value) return Refusal::unknown;
  if (a.index < 1 || a.index > enables) return Refusal::bad_index;
  if (*value != 0 && *value != 1) return Refusal::unknown;
  c.set_enable(static_cast<int>(a.index), *value != 0);
  return {};
}

Answer arm_latch(Controller& c, const Args& a) {
  const auto on = number_in(a.value, 0, 1);
  if (!on) return Refusal::unknown;
  c.arm_latch(a.axis, *on != 0);
  return {};
}

Answer latched_encoder(Controller& c, const Args& a) { return Answer::number(c.latch(a.axis).encoder); }
Answer latched_pulses(Controller& c, const Args& a) { return Answer::number(c.latch(a.axis).pulses); }
Answer latch_state(Controller& c, const Args& a) { return Answer::number(c.latch(a.axis).state); }
Answer sync_state(Controller& c, const Args& a) { return Answer::number(c.sync_state(a.axis)); }

// --- the rest ----------------------------------------------------------------------------------------------

Answer timer(Controller& c, const Args&) { return Answer::number(c.timer_ms()); }

Answer set_timer(Controller& c, const Args& a) {
  const auto ms = number_in(a.value, 0, arcus::max_number);
  if (!ms) return Refusal::unknown;
  if (c.timer_ms() > 0) return Refusal::timer_runs;
  c.set_timer(*ms);
  return {};
}

Answer first_program_state(Controller& c, const Args&) { return Answer::number(c.program_state(0)); }

constexpr Command table[] = {
    {"ABORT", abort_all},
    {"ABORTa", on_axis<&Controller::abort>},
    {"STOPa", on_axis<&Controller::stop>},
    {"CLRa", on_axis<&Controller::clear_errors>},
    {"CLRSa", on_axis<&Controller::clear_loop_error>},
    {"Jas", jog},
    {"Hasn", home},
    {"Tav", target},
    {"CIRPv", circle<true>},
    {"CIRNv", circle<false>},
    {"ARCPv", arc<true>},
    {"ARCNv", arc<false>},
    {"SSPDa=v", change_speed},
    {"BO", buffer_on},
    {"BF", buffer_off},
    {"PP", of_all<&Controller::position>},
    {"PE", of_all<&Controller::encoder>},
    {"PS", of_all<&Controller::speed>},
    {"Pa", of_axis<&Controller::position>},
    {"Pa=v", set_position},
    {"Ea", of_axis<&Controller::encoder>},
    {"Ea=v", set_encoder},
    {"MST", status},
    {"MSTa", of_axis<&Controller::status>},
    {"DXa", of_axis<&Controller::loop_delta>},
    {"SLSa", loop_state},
    {"AIn", analog},
    {"EOn", enable},
    {"EOn=v", set_enable},
    {"LTa=v", arm_latch},
    {"LTaE", latched_encoder},
    {"LTaP", latched_pulses},
    {"LTaS", latch_state},
    {"SYNaO", on_axis<&Controller::sync_on>},
    {"SYNaF", on_axis<&Controller::sync_off>},
    {"SYNaS", sync_state},
    {"TR", timer},
    {"TR=v", set_timer},
    {"SASTAT", first_program_state},
    {"Iv", buffer_move},
    {"av", move},
};

}  // namespace

std::span<const Command> commands() { return table; }

}  // namespace hw::pmx_4ex_sa
