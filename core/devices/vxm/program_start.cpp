#include "core/devices/vxm/program_start.h"

#include "core/base/index.h"
#include "core/devices/vxm/program_analysis.h"

namespace hw::vxm {
namespace {

constexpr std::int64_t couples_all_but_0 = -5;  // a number has no minus zero

/// The line rate changes no program, and the second name of a motor's type is known by the first.
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

/// The lines as they are held now: low is operated.
void hold(VxmEmulator& emulator, const Snapshot& now) {
  for (int line = 0; line < line_count; ++line) {
    const bool low = (now.inputs_known >> line & 1u) != 0 && (now.inputs >> line & 1u) == 0;
    if (!low) continue;
    if (line < inputs_per_controller)
      (void)emulator.operate(bench::Input(line + 1, true));
    else if (const int button = line - inputs_per_controller; button < line_run)
      (void)emulator.operate(bench::Button(std::string(panel_buttons[ix(button)]), true));
  }
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
                                             std::uint32_t moved) {
  std::vector<RehearsedAssumption> all = unknown_params(state, catalog, moved, acts_on_programs);
  for (RehearsedAssumption& a : unknown_surroundings(state, catalog, moved)) all.push_back(std::move(a));
  const int mode = catalog.find_param("DM");
  if (mode >= 0 && (state.param(ix(mode)).value_or(0) & mode_program_4_first) != 0)
    all.push_back({"first run since power-up", "no, so program 4 does not run first"});
  return all;
}

}  // namespace hw::vxm
