#include "core/devices/vme58/program_start.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/devices/vme58/catalog.h"

namespace hw::vme58 {
namespace {

/// Parameters set by one of two commands.
struct SwitchPair {
  std::string_view letters, off, on;
};
constexpr std::array<SwitchPair, 8> switches{{
    {"HN", "HF", "HN"},
    {"TN", "TF", "TN"},
    {"LN", "LF", "LN"},
    {"SL", "SF", "SL"},
    {"HH", "HL", "HH"},
    {"HE", "HS", "HE"},
    {"PA", "PA0", "PA1"},
    {"BI", "UN", "BI"},
}};
constexpr std::int64_t ramp_straight = 0, ramp_half_cosine = 11;

std::string number_of(const ParamInfo& info, std::int64_t value) {
  if (info.decimals == 0) return std::to_string(value);
  double unit = 1;
  for (int i = 0; i < info.decimals; ++i) unit *= 10;
  return fmt::format("{:.{}f}", static_cast<double>(value) / unit, info.decimals);
}

std::string setting_text(const ParamInfo& info, std::int64_t value) {
  const std::string letters = info.mnemonic.substr(0, 2);
  for (const SwitchPair& pair : switches)
    if (letters == pair.letters) return std::string(value != 0 ? pair.on : pair.off);
  if (letters == "PN" && value == ramp_straight) return "PF";
  if (letters == "PN" && value == ramp_half_cosine) return "CN";
  return letters + number_of(info, value);
}

std::string addressed(int axis, const std::string& command) {
  return axis < 0 ? command : fmt::format("A{} {}", axis_letters[ix(axis)], command);
}

}  // namespace

std::vector<std::string> text_to_begin_like(const ControllerState& state, const Catalog& catalog,
                                            const Variant& variant) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < catalog.params.size(); ++i) {
    const ParamInfo& info = catalog.params[i];
    const auto value = state.param(i);
    if (value && *value != info.fallback) all.push_back(addressed(info.axis, setting_text(info, *value)));
  }
  for (std::size_t place = 0; place < catalog.outputs.size(); ++place) {
    if ((state.now.outputs_known >> place & 1u) == 0) continue;
    const int number = catalog.outputs[place].number, auxiliary = number - first_auxiliary;
    const bool on = (state.now.outputs >> place & 1u) != 0;
    all.push_back(auxiliary >= 0 ? addressed(auxiliary, on ? "AN" : "AF")
                                 : addressed(0, fmt::format("{}{}", on ? "BL" : "BH", number)));
  }
  for (int i = 0; i < std::min(variant.axes(), state.now.axis_count); ++i) {
    const AxisState& axis = state.now.axes[ix(i)];
    if (axis.position_known) all.push_back(addressed(i, fmt::format("LP{}", axis.commanded().value)));
    if (axis.loop == Loop::open) all.push_back(addressed(i, "HF"));
  }
  return all;
}

void stand_like(Vme58Emulator& emulator, const ControllerState& state) {
  for (int i = 0; i < state.now.axis_count; ++i)
    if (const AxisState& axis = state.now.axes[ix(i)]; axis.has_encoder && axis.loop == Loop::none)
      emulator.board().motion().set_encoder(i, axis.encoder.value);
  for (int line = 0; line < io_lines; ++line)
    if (!emulator.board().io().is_output(line) && (state.now.inputs_known >> line & 1u) != 0)
      (void)emulator.operate(bench::Input(line + 1, (state.now.inputs >> line & 1u) == 0));
}

std::vector<RehearsedAssumption> assumptions(const ControllerState& state, const Catalog& catalog,
                                             std::uint32_t moved) {
  const auto any = [](const ParamInfo&) { return true; };
  std::vector<RehearsedAssumption> all = unknown_params(state, catalog, moved, any);
  for (RehearsedAssumption& a : unknown_surroundings(state, catalog, moved)) all.push_back(std::move(a));
  for (std::size_t place = 0; place < catalog.outputs.size(); ++place)
    if (state.now.outputs_known != 0 && (state.now.outputs_known >> place & 1u) == 0)
      all.push_back({catalog.outputs[place].name, "as after power-up"});
  for (int i = 0; i < state.now.axis_count; ++i)
    if ((moved >> i & 1u) != 0)
      all.push_back({fmt::format("UU{}", axis_letters[ix(i)]), "off: positions in counts"});
  bool named = false;
  for (int i = 0; i < state.now.axis_count; ++i) {
    const int waiting = catalog.queue_depth - state.now.queue_free[ix(i)];
    if ((state.now.queue_known >> i & 1u) == 0 || waiting <= 0) continue;
    named = true;
    all.push_back({"queue of " + catalog.axes[ix(i)].name,
                   fmt::format("empty, since the board does not report what its {} {}", waiting,
                               waiting == 1 ? "entry says" : "entries say")});
  }
  if (!named && state.now.shows_under_way().queued)
    all.push_back({"command queues", "empty, since the board does not report what waits there"});
  return all;
}

}  // namespace hw::vme58
