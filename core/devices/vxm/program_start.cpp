#include "core/devices/vxm/program_start.h"

#include <algorithm>
#include <array>

#include "core/base/index.h"
#include "core/devices/vxm/program_analysis.h"

namespace hw::vxm {
namespace {

constexpr std::int64_t couples_all_but_0 = -5;  // a number has no minus zero
constexpr std::array<int, 11> u_waits{0, 1, 13, 23, 30, 31, 32, 33, 50, 51, 90};  // U commands, App. B

/// The line rate changes no program, and the second name of a motor's type has the same value as the first.
bool acts_on_programs(const ParamInfo& info) { return info.readable; }

std::string set_word(const ParamInfo& info, std::int64_t value) {
  const std::string number = std::to_string(value);
  if (info.mnemonic == "Bx") return "B" + number;
  if (info.mnemonic == "O") return "O" + number;
  if (info.mnemonic == "PMA") return value == couples_all_but_0 ? "PMA-0" : "PMA" + number;
  return "set" + info.mnemonic + number;
}

void set_up(VxmEmulator& emulator, const ControllerState& state, const Catalog& catalog) {
  for (std::size_t i = 0; i < catalog.params.size(); ++i) {
    const ParamInfo& info = catalog.params[i];
    const auto value = state.param(i);
    if (value && *value != info.fallback && acts_on_programs(info))
      emulator.receive(set_word(info, *value) + "\r");
  }
}

std::string selecting(int slot) { return "PM-" + std::to_string(slot) + "\r"; }

void store(VxmEmulator& emulator, const std::map<int, std::string>& programs,
           const std::function<bool(int)>& text_fills) {
  for (const auto& [slot, text] : programs)
    if (slot >= 0 && slot < program_count && !text_fills(slot))
      emulator.receive(selecting(slot) + analyse_text(text, slot).script);
}

/// Keeps the inputs at their present levels (low is operated). Sets the analog input as last read.
void hold(VxmEmulator& emulator, const Snapshot& now) {
  for (int line = 0; line < line_count; ++line) {
    const bool low = (now.inputs_known >> line & 1u) != 0 && (now.inputs >> line & 1u) == 0;
    if (!low) continue;
    if (line < inputs_per_controller)
      (void)emulator.operate(bench::Input(line + 1, true));
    else if (const int button = line - inputs_per_controller; button < line_run)
      (void)emulator.operate(bench::Button(std::string(panel_buttons[ix(button)]), true));
  }
  if ((now.analog_known & 1u) != 0) (void)emulator.operate(bench::Analog(1, now.analog[0]));
}

/// Slots that a command may lead to: bit per slot.
std::uint32_t leads_to(const Command& c, bool input_3_branches) {
  if (c.op == Op::jump || c.op == Op::call || c.op == Op::call_pick) return 1u << c.value;
  const int u = c.value % slave_u_offset;
  if (c.op != Op::user || std::find(u_waits.begin(), u_waits.end(), u) == u_waits.end()) return 0;
  const bool by_button = u == 13 || u == 23;
  return (by_button ? 1u << 1 | 1u << 2 : 0u) | (input_3_branches ? 1u << 3 : 0u);
}

/// Programs that a run may reach, including its first: bit per program.
std::uint32_t programs_of_run(const ControllerState& state, const Catalog& catalog, const FinishedRun& ran) {
  const int inputs = catalog.find_param("I");
  const std::int64_t mode =
      inputs < 0 ? 0 : state.param(ix(inputs)).value_or(catalog.params[ix(inputs)].fallback);
  const bool branches = (mode & inputs_branch_3) != 0 && ran.box.line(line_in_3).low;
  std::uint32_t all = 1u << ran.slot;
  for (std::uint32_t before = 0; before != all;) {
    before = all;
    for (int slot = 0; slot < program_count; ++slot)
      if ((before >> slot & 1u) != 0)
        for (const Command& c : ran.box.program(slot).commands()) all |= leads_to(c, branches);
  }
  return all;
}

bool uses_analog(const Program& program) {
  return std::any_of(program.commands().begin(), program.commands().end(), [](const Command& c) {
    return c.op == Op::analog_speed || c.op == Op::analog_speed_full;
  });
}

/// Adds unread programs, and the analog input, where the run may meet them.
void add_met(std::vector<RehearsedAssumption>& all, const ControllerState& state, const Catalog& catalog,
             const FinishedRun& ran) {
  const std::uint32_t met = programs_of_run(state, catalog, ran);
  bool by_analog = false;
  for (int slot = 0; slot < program_count; ++slot) {
    if ((met >> slot & 1u) == 0) continue;
    by_analog = by_analog || uses_analog(ran.box.program(slot));
    const bool known =
        ran.text_fills(slot) || state.programs.contains(slot) || state.now.slot_bytes_used[ix(slot)] == 0;
    if (!known) all.push_back(unread_program(slot));
  }
  if (by_analog && (state.now.analog_known & 1u) == 0)
    all.push_back({"analog input", std::to_string(analog_default) + ", the middle"});
}

}  // namespace

void begin_like(VxmEmulator& emulator, const ControllerState& state, const Catalog& catalog,
                const std::function<bool(int)>& text_fills) {
  set_up(emulator, state, catalog);
  store(emulator, state.programs, text_fills);
  emulator.box().has_run_before();
  constexpr std::uint32_t all = (1u << outputs_per_controller) - 1;
  if ((state.now.outputs_known & all) == all)
    emulator.box().set_outputs(static_cast<int>(state.now.outputs & all));
  hold(emulator, state.now);
}

std::vector<RehearsedAssumption> assumptions(const ControllerState& state, const Catalog& catalog,
                                             std::uint32_t moved, const FinishedRun& ran) {
  std::vector<RehearsedAssumption> all = unknown_params(state, catalog, moved, acts_on_programs);
  for (RehearsedAssumption& a : unknown_surroundings(state, catalog, moved)) all.push_back(std::move(a));
  const int mode = catalog.find_param("DM");
  if (mode >= 0 && (state.param(ix(mode)).value_or(0) & mode_program_4_first) != 0)
    all.push_back({"first run since power-up", "no, so program 4 does not run first"});
  add_met(all, state, catalog, ran);
  return all;
}

}  // namespace hw::vxm
