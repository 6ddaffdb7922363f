#include "gui/model/rehearsals.h"

#include <bit>
#include <utility>

#include "core/base/index.h"
#include "gui/model/text_diff.h"

namespace hw::gui {
namespace {

bool runs(const ProgramState& p) { return p.owned && p.run != RunState::idle && p.run != RunState::error; }

Footing footing_of(const RehearsedAxis& rehearsed, const AxisState& axis, bool moves) {
  if (!axis.position_known) return Footing::unknown;
  if (axis.trust.doubtful()) return Footing::doubtful;
  if (rehearsed.in_counts != axis.in_counts) return Footing::other_count;
  if (moves) return Footing::moving;
  return rehearsed.begin == axis.commanded().value ? Footing::here : Footing::elsewhere;
}

Stand compare_axes(const Rehearsal& rehearsal, const Snapshot& began, const Snapshot& now, bool left,
                   const Catalog& catalog) {
  for (const RehearsedAxis& rehearsed : rehearsal.axes) {
    const int i = catalog.find_axis(rehearsed.name);
    if (i < 0 || i >= now.axis_count) continue;
    const AxisState &then = began.axes[ix(i)], &axis = left ? then : now.axes[ix(i)];
    const Footing footing = footing_of(rehearsed, axis, (left ? began : now).axis_moves(i));
    const bool tells_place = footing == Footing::elsewhere;
    if (footing != Footing::here)
      return {footing, i, Steps(rehearsed.begin), tells_place ? axis.commanded() : Steps()};
    if (axis.enabled != then.enabled || axis.error != then.error) return {Footing::other_power, i, {}, {}};
  }
  return {};
}

/// What was not known was taken as from the factory.
Stand compare_params(const Snapshot& began, const Snapshot& now, const Catalog& catalog) {
  for (std::size_t i = 0; i < catalog.params.size(); ++i) {
    const ParamState &then = began.params[i], &is = now.params[i];
    const std::int64_t taken = then.known ? then.value : catalog.params[i].fallback;
    if (is.known && is.value != taken)
      return {Footing::other_setup, static_cast<int>(i), Steps(taken), Steps(is.value)};
  }
  return {};
}

Stand compare_bits(Footing footing, std::uint32_t then, std::uint32_t now, std::uint32_t known) {
  const std::uint32_t other = (then ^ now) & known;
  if (other == 0) return {};
  const int which = std::countr_zero(other);
  return {footing, which, Steps(then >> which & 1u), Steps(now >> which & 1u)};
}

Stand compare_variables(const Snapshot& began, const Snapshot& now) {
  if ((began.variables_known | now.variables_known).none()) return {};
  for (int n = 0; n < max_variables; ++n) {
    const std::int32_t taken = began.variables_known.test(ix(n)) ? began.variables[ix(n)] : 0;
    if (now.variables_known.test(ix(n)) && now.variables[ix(n)] != taken)
      return {Footing::other_variable, n, Steps(taken), Steps(now.variables[ix(n)])};
  }
  return {};
}

Stand compare_programs(const ControllerState& began, int slot, const Rehearsals::Held& held) {
  for (const auto& [other, text] : began.programs) {
    const std::string* now = other == slot || !held ? nullptr : held(other);
    if (now && *now != text) return {Footing::other_program, other, {}, {}};
  }
  return {};
}

/// What is asked first is told first.
Stand compare(int slot, const Rehearsals::Outcome& outcome, const Snapshot& now, const BenchView& bench,
              bool left, const Catalog& catalog, const Rehearsals::Held& held) {
  const ControllerState& from = *outcome.scene.state;
  const Snapshot& began = from.now;
  if (const Stand s = compare_axes(*outcome.result, began, now, left, catalog); s != Stand()) return s;
  if (left) return {};
  const bool known = outcome.scene.switches.has_value();
  if (known != bench.present || (known && *outcome.scene.switches != bench.switches))
    return {Footing::other_bench, -1, {}, {}};
  if (const Stand s = compare_params(began, now, catalog); s != Stand()) return s;
  if (const Stand s = compare_bits(Footing::other_output, began.outputs, now.outputs,
                                   began.outputs_known & now.outputs_known);
      s != Stand())
    return s;
  if (const Stand s =
          compare_bits(Footing::other_input, began.inputs, now.inputs, began.inputs_known & now.inputs_known);
      s != Stand())
    return s;
  if (const Stand s = compare_variables(began, now); s != Stand()) return s;
  return compare_programs(from, slot, held);
}

}  // namespace

void Rehearsals::start(const Language& language, std::string text, const RehearseOptions& wish,
                       ControllerState from, const BenchView& bench, const Catalog& catalog, Worker& worker) {
  const int slot = wish.slot;
  if (under_way(slot)) return;
  running_[slot] = true;
  Scene scene{std::make_shared<const ControllerState>(std::move(from)), std::nullopt};
  if (bench.present) scene.switches = bench.switches;
  RehearseOptions options = rehearse_from(scene.state, bench, catalog);
  options.slot = slot, options.for_seconds = wish.for_seconds, options.track_every_s = wish.track_every_s;
  worker.run(
      [&language, text = std::move(text), options = std::move(options), scene = std::move(scene)]() mutable {
        auto result = language.rehearse(text, options);
        return Outcome{std::move(text), std::move(result), std::move(scene)};
      },
      [this, slot](Outcome outcome) {
        running_.erase(slot);
        outcome.number = ++version_;
        outcomes_.insert_or_assign(slot, std::move(outcome));
      },
      alive_);
}

const Rehearsals::Outcome* Rehearsals::of(int slot) const {
  const auto found = outcomes_.find(slot);
  return found == outcomes_.end() ? nullptr : &found->second;
}

int Rehearsals::older_than_line(int slot, std::string_view text) const {
  const Outcome* outcome = of(slot);
  return outcome ? TextDiff(outcome->text, text).first_changed() : -1;
}

void Rehearsals::follow(const Snapshot& now, const BenchView& bench, const Catalog& catalog,
                        const Held& held) {
  const bool left = runs(now.program);
  for (auto& [slot, outcome] : outcomes_) {
    const bool first = !std::exchange(outcome.compared, true);
    if (!outcome.result || (left && !first)) continue;
    const Stand stand = compare(slot, outcome, now, bench, left, catalog, held);
    if (stand == outcome.stand) continue;
    outcome.stand = stand;
    ++version_;
  }
}

}  // namespace hw::gui
