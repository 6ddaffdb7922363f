#include "gui/rehearsals.h"

#include <utility>

#include "gui/text_diff.h"

namespace hw::gui {
namespace {

bool runs(const ProgramState& p) { return p.owned && p.run != RunState::idle && p.run != RunState::error; }

std::optional<Steps> seen_from(const std::optional<Steps>& place, Steps from) {
  return place ? std::optional(*place - from) : std::nullopt;
}

/// The emulated controller of a rehearsal begins with its loads at 0: the switches come nearer instead.
std::vector<BenchCommand> moved_bench(const BenchView& bench, int axes) {
  std::vector<BenchCommand> all;
  for (int i = 0; i < axes; ++i) {
    const AxisId axis{static_cast<std::uint8_t>(i)};
    const std::uint32_t bit = 1u << i;
    const SwitchPlaces& switches = bench.switches[axis.index];
    const Steps load = bench.load_position[axis.index];
    AxisPlace place;
    all.emplace_back(bench::Place(axis, place));  // without those that an emulator is made with
    place.minus = seen_from(switches.minus, load), place.plus = seen_from(switches.plus, load);
    place.home_from = seen_from(switches.home_from, load), place.home_to = seen_from(switches.home_to, load);
    if (switches != SwitchPlaces()) all.emplace_back(bench::Place(axis, place));
    if (bench.limits_minus_by_hand & bit) all.emplace_back(bench::Limit(axis, Sign::minus, true));
    if (bench.limits_plus_by_hand & bit) all.emplace_back(bench::Limit(axis, Sign::plus, true));
    if (bench.homes_by_hand & bit) all.emplace_back(bench::HomeSwitch(axis, true));
  }
  return all;
}

Footing footing_of(const RehearsedAxis& rehearsed, const AxisState& axis, bool moves) {
  if (!axis.position_known) return Footing::unknown;
  if (axis.trust.doubtful()) return Footing::doubtful;
  if (rehearsed.in_counts != axis.in_counts) return Footing::other_count;
  if (moves) return Footing::moving;
  return rehearsed.begin == axis.commanded().value ? Footing::here : Footing::elsewhere;
}

Stand compare(const Rehearsals::Outcome& outcome, const Rehearsals::Scene& now, const Catalog& catalog) {
  for (const RehearsedAxis& rehearsed : outcome.result->axes) {
    const int i = catalog.find_axis(rehearsed.name);
    if (i < 0 || i >= now.axis_count) continue;
    const AxisState& axis = now.axes[static_cast<std::size_t>(i)];
    const Footing footing = footing_of(rehearsed, axis, now.moving >> i & 1u);
    if (footing == Footing::here) continue;
    const bool tells_place = footing == Footing::elsewhere;
    return {footing, i, Steps(rehearsed.begin), tells_place ? axis.commanded() : Steps()};
  }
  if (outcome.scene.switches != now.switches) return {Footing::other_bench, -1, {}, {}};
  return {};
}

}  // namespace

Rehearsals::Scene::Scene(const Snapshot& now, const BenchView& bench)
    : axes(now.axes), axis_count(now.axis_count) {
  for (int i = 0; i < axis_count; ++i) moving |= std::uint32_t{now.axis_moves(i)} << i;
  if (bench.present) switches = bench.switches;
}

void Rehearsals::start(const Language& language, std::string text, RehearseOptions options,
                       const Snapshot& now, const BenchView& bench, Worker& worker) {
  const int slot = options.slot;
  if (under_way(slot)) return;
  running_[slot] = true;
  options.start_at.clear();
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[static_cast<std::size_t>(i)];
    options.start_at.push_back(axis.position_known ? axis.commanded().value : 0);
  }
  if (bench.present) options.bench = moved_bench(bench, now.axis_count);
  worker.run(
      [&language, text = std::move(text), options = std::move(options), scene = Scene(now, bench)]() mutable {
        auto result = language.rehearse(text, options);
        return Outcome{std::move(text), std::move(result), scene};
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

void Rehearsals::follow(const Snapshot& now, const BenchView& bench, const Catalog& catalog) {
  const bool left = runs(now.program);
  for (auto& [slot, outcome] : outcomes_) {
    const bool first = !std::exchange(outcome.compared, true);
    if (!outcome.result || (left && !first)) continue;
    const Stand stand = compare(outcome, left ? outcome.scene : Scene(now, bench), catalog);
    if (stand == outcome.stand) continue;
    outcome.stand = stand;
    ++version_;
  }
}

}  // namespace hw::gui
