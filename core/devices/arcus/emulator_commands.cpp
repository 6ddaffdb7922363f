// The commands that both models have, beside their settings (chapter 9 of both manuals).
#include "core/devices/arcus/emulator_command.h"

namespace hw::arcus {
namespace {

using Args = Arguments;

template <void (Controller::*act)()>
Answer plain(Controller& c, const Args&) {
  (c.*act)();
  return {};
}

Answer absolute(Controller& c, const Args&) {
  c.set_incremental(false);
  return {};
}

Answer incremental(Controller& c, const Args&) {
  c.set_incremental(true);
  return {};
}

Answer clear_all(Controller& c, const Args&) {
  for (int a = 0; a < c.axes(); ++a) c.clear_errors(a);
  return {};
}

Answer clear_loops(Controller& c, const Args&) {
  for (int a = 0; a < c.axes(); ++a) c.clear_loop_error(a);
  return {};
}

Answer product(Controller& c, const Args&) { return std::string(c.model().product); }
Answer version(Controller& c, const Args&) { return std::string(c.model().version); }

Answer store(Controller& c, const Args&) {
  c.store();
  return {};
}

// --- inputs and outputs ------------------------------------------------------------------------------------

Answer one_bit(std::int64_t word, const Args& a, int count) {
  if (a.index < 1 || a.index > count) return Refusal::bad_index;
  return Answer::number(word >> (a.index - 1) & 1);
}

/// Syntax before index before range (decision AMB-035).
Refusal bad_bit(const Args& a, int count) {
  if (!parse_integer(a.value)) return Refusal::unknown;
  if (a.index < 1 || a.index > count) return Refusal::bad_index;
  return number_in(a.value, 0, 1) ? Refusal::none : Refusal::unknown;
}

Answer inputs(Controller& c, const Args&) { return Answer::number(c.inputs()); }
Answer input(Controller& c, const Args& a) { return one_bit(c.inputs(), a, c.model().inputs); }
Answer outputs(Controller& c, const Args&) { return Answer::number(c.outputs()); }
Answer output(Controller& c, const Args& a) { return one_bit(c.outputs(), a, c.model().outputs); }

Answer set_outputs(Controller& c, const Args& a) {
  const auto value = number_in(a.value, 0, (std::int64_t{1} << c.model().outputs) - 1);
  if (!value) return Refusal::unknown;
  c.set_outputs(*value);
  return {};
}

Answer set_output(Controller& c, const Args& a) {
  if (const Refusal r = bad_bit(a, c.model().outputs); r != Refusal::none) return r;
  c.set_output(static_cast<int>(a.index), *parse_integer(a.value) != 0);
  return {};
}

Answer enables(Controller& c, const Args&) { return Answer::number(c.enables()); }

Answer set_enables(Controller& c, const Args& a) {
  const auto value = number_in(a.value, 0, (std::int64_t{1} << c.model().enables) - 1);
  if (!value) return Refusal::unknown;
  c.set_enables(*value);
  return {};
}

// --- variables and programs --------------------------------------------------------------------------------

Answer variable(Controller& c, const Args& a) {
  if (a.index >= variables) return Refusal::bad_index;
  return Answer::number(c.variable(static_cast<int>(a.index)));
}

Answer set_variable(Controller& c, const Args& a) {
  if (!parse_integer(a.value)) return Refusal::unknown;
  if (a.index >= variables) return Refusal::bad_index;
  const auto value = number_in(a.value, INT32_MIN, INT32_MAX);
  if (!value) return Refusal::unknown;
  c.set_variable(static_cast<int>(a.index), static_cast<std::int32_t>(*value));
  return {};
}

Answer program_line(Controller& c, const Args& a) {
  if (a.index >= program_lines) return Refusal::bad_index;
  return c.program_line(static_cast<int>(a.index));
}

/// An empty text makes the line unused again; none begins with '=' (decision AMB-028).
Answer set_program_line(Controller& c, const Args& a) {
  if (a.value.starts_with('=')) return Refusal::unknown;
  if (a.value.size() > static_cast<std::size_t>(max_line_text)) return Refusal::unknown;
  if (a.index >= program_lines) return Refusal::bad_index;
  return c.set_program_line(static_cast<int>(a.index), a.value);
}

Answer program_state(Controller& c, const Args& a) {
  if (a.index >= c.model().programs) return Refusal::bad_index;
  return Answer::number(c.program_state(static_cast<int>(a.index)));
}

Answer program_place(Controller& c, const Args& a) {
  if (a.index >= c.model().programs) return Refusal::bad_index;
  return Answer::number(c.program_place(static_cast<int>(a.index)));
}

Answer control_program(Controller& c, const Args& a) {
  if (!parse_integer(a.value)) return Refusal::unknown;
  if (a.index >= c.model().programs) return Refusal::bad_index;
  const auto what = number_in(a.value, 0, 3);
  if (!what) return Refusal::unknown;
  c.control_program(static_cast<int>(a.index), static_cast<int>(*what));
  return {};
}

Answer call_subroutine(Controller& c, const Args& a) {
  if (a.index >= subroutines) return Refusal::bad_index;
  return c.call_subroutine(static_cast<int>(a.index));
}

constexpr Command table[] = {
    {"ABS", absolute},
    {"INC", incremental},
    {"STOP", plain<&Controller::stop_all>},
    {"CLR", clear_all},
    {"CLRS", clear_loops},
    {"ID", product},
    {"VER", version},
    {"STORE", store},
    {"DI", inputs},
    {"DIn", input},
    {"DO", outputs},
    {"DOn", output},
    {"DO=v", set_outputs},
    {"DOn=v", set_output},
    {"EO", enables},
    {"EO=v", set_enables},
    {"Vn", variable},
    {"Vn=v", set_variable},
    {"SAn", program_line},
    {"SAn=v", set_program_line},
    {"SASTATn", program_state},
    {"SPCn", program_place},
    {"SRn=v", control_program},
    {"GSn", call_subroutine},
};

}  // namespace

std::span<const Command> common_commands() { return table; }

}  // namespace hw::arcus
