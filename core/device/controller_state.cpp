#include "core/device/controller_state.h"

#include <charconv>

#include <fmt/format.h>

#include "core/base/index.h"

namespace hw {
namespace {

std::optional<Steps> seen_from(const std::optional<Steps>& place, Steps from) {
  return place ? std::optional(*place - from) : std::nullopt;
}

/// The emulated controller of a rehearsal begins with its loads at 0: the switches are shifted instead.
std::vector<BenchCommand> moved_bench(const BenchView& bench, int axes) {
  std::vector<BenchCommand> all;
  for (int i = 0; i < axes; ++i) {
    const AxisId axis{static_cast<std::uint8_t>(i)};
    const std::uint32_t bit = 1u << i;
    const SwitchPlaces& switches = bench.switches[axis.index];
    const Steps load = bench.load_position[axis.index];
    AxisPlace place;
    all.emplace_back(bench::Place(axis, place));  // without the switches that a new emulator has
    place.minus = seen_from(switches.minus, load), place.plus = seen_from(switches.plus, load);
    place.home_from = seen_from(switches.home_from, load), place.home_to = seen_from(switches.home_to, load);
    if (switches != SwitchPlaces()) all.emplace_back(bench::Place(axis, place));
    if (bench.limits_minus_by_hand & bit) all.emplace_back(bench::Limit(axis, Sign::minus, true));
    if (bench.limits_plus_by_hand & bit) all.emplace_back(bench::Limit(axis, Sign::plus, true));
    if (bench.homes_by_hand & bit) all.emplace_back(bench::HomeSwitch(axis, true));
  }
  return all;
}

/// The switches of a real machine are at unknown positions, except those that are operated now.
std::vector<BenchCommand> seen_switches(const Snapshot& now) {
  std::vector<BenchCommand> all;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[ix(i)];
    if (!axis.limits_known || axis.limit_minus == axis.limit_plus) continue;
    AxisPlace here;
    (axis.limit_minus ? here.minus : here.plus) = Steps(0);
    all.emplace_back(bench::Place(AxisId{static_cast<std::uint8_t>(i)}, here));
  }
  return all;
}

constexpr std::string_view program_word = "program ", taken_as_empty = "empty, because it was not read";

bool concerns(const ParamInfo& info, std::uint32_t moved) {
  return info.axis < 0 || (moved >> info.axis & 1u) != 0;
}

}  // namespace

RehearseOptions rehearse_from(std::shared_ptr<const ControllerState> state, const BenchView& bench,
                              const Catalog& catalog) {
  RehearseOptions options;
  options.axes = static_cast<int>(catalog.axes.size());
  options.device = catalog.made_from;
  const Snapshot& now = state->now;
  options.bench = bench.present ? moved_bench(bench, now.axis_count) : seen_switches(now);
  options.from = std::move(state);
  return options;
}

std::vector<RehearsedAssumption> unknown_params(const ControllerState& state, const Catalog& catalog,
                                                std::uint32_t moved,
                                                const std::function<bool(const ParamInfo&)>& matters) {
  std::vector<RehearsedAssumption> all;
  for (std::size_t i = 0; i < catalog.params.size(); ++i) {
    const ParamInfo& info = catalog.params[i];
    if (!state.param(i) && concerns(info, moved) && matters(info))
      all.push_back({info.mnemonic, param_words(info, info.fallback)});
  }
  return all;
}

std::vector<RehearsedAssumption> unknown_surroundings(const ControllerState& state, const Catalog& catalog,
                                                      std::uint32_t moved) {
  std::vector<RehearsedAssumption> all;
  for (std::size_t i = 0; i < catalog.axes.size(); ++i) {
    const bool known = static_cast<int>(i) < state.now.axis_count && state.now.axes[i].position_known;
    if (!known && (moved >> i & 1u) != 0) all.push_back({"position of " + catalog.axes[i].name, "0"});
  }
  if (!catalog.inputs.empty() && state.now.inputs_known == 0) all.push_back({"inputs", "not operated"});
  if (!catalog.outputs.empty() && state.now.outputs_known == 0)
    all.push_back({"outputs", "as after power-up"});
  return all;
}

RehearsedAssumption unread_program(int slot) {
  return {fmt::format("{}{}", program_word, slot), std::string(taken_as_empty)};
}

std::optional<int> unread_slot(const RehearsedAssumption& assumption) {
  const std::string_view name = assumption.name;
  if (assumption.value != taken_as_empty || !name.starts_with(program_word)) return std::nullopt;
  int slot = -1;
  std::from_chars(name.data() + program_word.size(), name.data() + name.size(), slot);
  return slot < 0 ? std::nullopt : std::optional(slot);
}

bool acts_on_programs(const ReadoutInfo& readout) {
  const std::string_view id = readout.id;
  const bool of_axis = readout.axis >= 0;
  return id == "MM" || (of_axis && (id.starts_with("LT") || id.starts_with("SYN")));
}

std::string param_words(const ParamInfo& info, std::int64_t value) {
  std::string number = std::to_string(value);
  if (info.decimals > 0) {
    double unit = 1;
    for (int i = 0; i < info.decimals; ++i) unit *= 10;
    number = fmt::format("{:.{}f}", static_cast<double>(value) / unit, info.decimals);
  }
  return info.unit.empty() ? number : number + " " + info.unit;
}

}  // namespace hw
