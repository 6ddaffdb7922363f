#include "gui/model/rehearsals.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "core/base/index.h"
#include "gui/model/text_diff.h"

namespace hw::gui {
namespace {

bool runs(const ProgramState& p) { return p.owned && p.run != RunState::idle && p.run != RunState::error; }

// These readings fluctuate even when nothing changes.
constexpr int analog_steps_of_range = 100;
constexpr std::int64_t encoder_jitter = 2;

bool within_jitter(std::int64_t then, std::int64_t now, std::int64_t by) {
  return std::max(then, now) - std::min(then, now) <= by;
}

/// The two sides of a comparison with a rehearsal's initial state.
struct Comparison {
  const Rehearsal& rehearsal;
  const ControllerState& from;
  const Snapshot& now;
  const Catalog& catalog;
  const std::set<int>& fills;  ///< slots of the rehearsed text
  const Rehearsals::Held& held;
  bool left;  ///< the controller has moved on since: only its initial axis states are judged
};

// ---- axes

/// The facts about an axis from which a rehearsal begins, and their certainty.
AxisState begins_as(const AxisState& axis) {
  AxisState a;
  a.position_known = axis.position_known, a.trust = axis.trust, a.activity = axis.activity;
  a.position = a.command = axis.commanded(), a.in_counts = axis.in_counts;
  if (axis.loop != Loop::none)
    a.loop = axis.loop == Loop::open || axis.loop == Loop::unknown ? axis.loop : Loop::in_place;
  a.has_encoder = axis.has_encoder && axis.loop == Loop::none;
  if (a.has_encoder) a.encoder = axis.encoder;
  a.enabled = axis.enabled, a.error = axis.error, a.alarm = axis.alarm;
  a.limits_known = axis.limits_known;
  if (a.limits_known) a.limit_minus = axis.limit_minus, a.limit_plus = axis.limit_plus, a.home = axis.home;
  return a;
}

void take_axes(const ControllerState& of, const Catalog&, ControllerState& into) {
  into.now.axis_count = of.now.axis_count;
  for (int i = 0; i < of.now.axis_count; ++i) into.now.axes[ix(i)] = begins_as(of.now.axes[ix(i)]);
}

/// `then`: as given to the rehearsal. Its results are in the count of the axis at its end, which the text may
/// change.
StartMatch match_of_axis(const RehearsedAxis& rehearsed, const AxisState& then, const AxisState& axis,
                         bool moves) {
  if (!axis.position_known) return StartMatch::unknown;
  if (axis.trust.doubtful()) return StartMatch::doubtful;
  if (then.in_counts != axis.in_counts) return StartMatch::other_count;
  if (moves) return StartMatch::moving;
  return rehearsed.begin == axis.commanded().value ? StartMatch::here : StartMatch::elsewhere;
}

/// Both as made by begins_as(); their positions have been compared already.
StartDifference other_state(int i, const AxisState& then, AxisState now) {
  const auto is = [i](StartMatch match, bool unread = false) {
    return StartDifference{match, i, {}, {}, unread};
  };
  now.position = then.position, now.command = then.command, now.position_known = then.position_known;
  now.trust = then.trust, now.activity = then.activity;
  const bool same_encoder = within_jitter(then.encoder.value, now.encoder.value, encoder_jitter);
  if (then.has_encoder && now.has_encoder && !same_encoder) return is(StartMatch::other_encoder);
  const bool loop_lost = now.loop == Loop::unknown && then.loop != Loop::unknown;
  if (loop_lost) return is(StartMatch::other_power, true);
  if (then.loop == Loop::unknown && now.loop == Loop::in_place) now.loop = then.loop;  // taken as closed
  now.has_encoder = then.has_encoder, now.encoder = then.encoder;
  AxisState same_switches = now;
  same_switches.limits_known = then.limits_known;
  same_switches.limit_minus = then.limit_minus, same_switches.limit_plus = then.limit_plus;
  same_switches.home = then.home;
  if (same_switches != then) return is(StartMatch::other_power);
  if (!then.limits_known || now == then) return {};
  return is(StartMatch::other_switch, !now.limits_known);
}

StartDifference compare_axes(const Comparison& c) {
  const Snapshot& began = c.from.now;
  for (const RehearsedAxis& rehearsed : c.rehearsal.axes) {
    const int i = c.catalog.find_axis(rehearsed.name);
    if (i < 0 || i >= c.now.axis_count) continue;
    const AxisState &then = began.axes[ix(i)], &axis = c.left ? then : c.now.axes[ix(i)];
    const StartMatch match = match_of_axis(rehearsed, then, axis, (c.left ? began : c.now).axis_moves(i));
    const bool names_place = match == StartMatch::elsewhere;
    if (match != StartMatch::here)
      return {match, i, Steps(rehearsed.begin), names_place ? axis.commanded() : Steps()};
    if (const StartDifference other = other_state(i, then, begins_as(axis)); other != StartDifference())
      return other;
  }
  return {};
}

// ---- other initial facts

void take_params(const ControllerState& of, const Catalog&, ControllerState& into) {
  into.now.params = of.now.params;
}
/// Unknown parameters were assumed to have factory values.
StartDifference compare_params(const Comparison& c) {
  for (std::size_t i = 0; i < c.catalog.params.size(); ++i) {
    const ParamState &then = c.from.now.params[i], &is = c.now.params[i];
    const std::int64_t taken = then.known ? then.value : c.catalog.params[i].fallback;
    if (is.known && is.value != taken)
      return {StartMatch::other_setup, static_cast<int>(i), Steps(taken), Steps(is.value)};
    if (then.known && !is.known)
      return {StartMatch::other_setup, static_cast<int>(i), Steps(taken), {}, true};
  }
  return {};
}

/// One side of a comparison of lines: bit per line.
struct Levels {
  std::uint32_t levels, known;
};
StartDifference compare_bits(StartMatch match, Levels then, Levels now) {
  const std::uint32_t other = (then.levels ^ now.levels) & then.known & now.known;
  const std::uint32_t unread = then.known & ~now.known;
  if ((other | unread) == 0) return {};
  const int which = std::countr_zero(other != 0 ? other : unread);
  const Steps began(then.levels >> which & 1u);
  if (other == 0) return {match, which, began, {}, true};
  return {match, which, began, Steps(now.levels >> which & 1u)};
}

void take_outputs(const ControllerState& of, const Catalog&, ControllerState& into) {
  into.now.outputs = of.now.outputs, into.now.outputs_known = of.now.outputs_known;
}
StartDifference compare_outputs(const Comparison& c) {
  const Snapshot &then = c.from.now, &now = c.now;
  return compare_bits(StartMatch::other_output, {then.outputs, then.outputs_known},
                      {now.outputs, now.outputs_known});
}

void take_inputs(const ControllerState& of, const Catalog&, ControllerState& into) {
  into.now.inputs = of.now.inputs, into.now.inputs_known = of.now.inputs_known;
}
StartDifference compare_inputs(const Comparison& c) {
  const Snapshot &then = c.from.now, &now = c.now;
  return compare_bits(StartMatch::other_input, {then.inputs, then.inputs_known},
                      {now.inputs, now.inputs_known});
}

void take_analog(const ControllerState& of, const Catalog&, ControllerState& into) {
  into.now.analog = of.now.analog, into.now.analog_known = of.now.analog_known;
}
StartDifference compare_analog(const Comparison& c) {
  const Snapshot &then = c.from.now, &now = c.now;
  for (std::size_t n = 0; n < c.catalog.analog.size(); ++n) {
    const AnalogInfo& info = c.catalog.analog[n];
    if ((then.analog_known >> n & 1u) == 0) continue;
    const bool known = (now.analog_known >> n & 1u) != 0;
    if (!known) return {StartMatch::other_analog, static_cast<int>(n), Steps(then.analog[n]), {}, true};
    const std::int64_t still = (std::int64_t{info.maximum} - info.minimum) / analog_steps_of_range;
    if (!within_jitter(then.analog[n], now.analog[n], still))
      return {StartMatch::other_analog, static_cast<int>(n), Steps(then.analog[n]), Steps(now.analog[n])};
  }
  return {};
}

void take_readouts(const ControllerState& of, const Catalog& catalog, ControllerState& into) {
  for (std::size_t i = 0; i < catalog.readouts.size(); ++i) {
    if (!acts_on_programs(catalog.readouts[i])) continue;
    into.now.readouts[i] = of.now.readouts[i];
    into.now.readouts_known.set(i, of.now.readouts_known.test(i));
  }
}
/// An unknown readout was assumed to be as after power-up: 0.
StartDifference compare_readouts(const Comparison& c) {
  for (std::size_t i = 0; i < c.catalog.readouts.size(); ++i) {
    if (!acts_on_programs(c.catalog.readouts[i])) continue;
    const bool was_known = c.from.now.readouts_known.test(i);
    const std::int64_t then = was_known ? c.from.now.readouts[i] : 0;
    if (!c.now.readouts_known.test(i)) {
      if (was_known) return {StartMatch::other_readout, static_cast<int>(i), Steps(then), {}, true};
      continue;
    }
    if (const std::int64_t is = c.now.readouts[i]; then != is)
      return {StartMatch::other_readout, static_cast<int>(i), Steps(then), Steps(is)};
  }
  return {};
}

void take_variables(const ControllerState& of, const Catalog&, ControllerState& into) {
  into.now.variables = of.now.variables, into.now.variables_known = of.now.variables_known;
}
StartDifference compare_variables(const Comparison& c) {
  const Snapshot &began = c.from.now, &now = c.now;
  if ((began.variables_known | now.variables_known).none()) return {};
  for (int n = 0; n < max_variables; ++n) {
    const bool was_known = began.variables_known.test(ix(n));
    const std::int32_t taken = was_known ? began.variables[ix(n)] : 0;
    if (was_known && !now.variables_known.test(ix(n)))
      return {StartMatch::other_variable, n, Steps(taken), {}, true};
    if (now.variables_known.test(ix(n)) && now.variables[ix(n)] != taken)
      return {StartMatch::other_variable, n, Steps(taken), Steps(now.variables[ix(n)])};
  }
  return {};
}

/// If one text holds all programs, it is the rehearsed text.
void take_programs(const ControllerState& of, const Catalog& catalog, ControllerState& into) {
  if (catalog.program.threads == 0) into.programs = of.programs;
}
/// Unread programs were assumed to be empty.
StartDifference compare_programs(const Comparison& c) {
  if (!c.held) return {};
  for (const auto& [other, text] : c.from.programs) {
    if (c.fills.contains(other)) continue;
    const std::string* now = c.held(other);
    if (!now || *now != text) return {StartMatch::other_program, other, {}, {}, now == nullptr};
  }
  for (const RehearsedAssumption& assumption : c.rehearsal.assumptions) {
    const auto slot = unread_slot(assumption);
    const std::string* now = slot ? c.held(*slot) : nullptr;
    if (now && !now->empty()) return {StartMatch::other_program, *slot, {}, {}};
  }
  return {};
}

/// No rehearsal begins from these: they only show which assumptions it has to name.
void take_sizes(const ControllerState& of, const Catalog&, ControllerState& into) {
  into.now.slot_bytes_used = of.now.slot_bytes_used;
}
/// A program known to be empty was not read.
StartDifference compare_sizes(const Comparison& c) {
  if (c.catalog.program.threads != 0) return {};
  for (int slot = 0; slot < std::min(c.catalog.program.slots, max_slots); ++slot) {
    const int then = c.from.now.slot_bytes_used[ix(slot)], now = c.now.slot_bytes_used[ix(slot)];
    if (then == 0 && now != 0 && !c.fills.contains(slot))
      return {StartMatch::other_program, slot, {}, {}, now < 0};
  }
  return {};
}

bool commands_wait(const Snapshot& now, const Catalog& catalog) {
  if ((now.working && catalog.queue_depth > 0) || now.feed.running) return true;
  for (int i = 0; i < now.axis_count; ++i)
    if ((now.queue_known >> i & 1u) != 0 && now.queue_free[ix(i)] < catalog.queue_depth) return true;
  return false;
}
void take_queue(const ControllerState& of, const Catalog&, ControllerState& into) {
  into.now.working = of.now.working, into.now.feed = of.now.feed;
  into.now.queue_free = of.now.queue_free, into.now.queue_known = of.now.queue_known;
}
StartDifference compare_queue(const Comparison& c) {
  return commands_wait(c.now, c.catalog) ? StartDifference{StartMatch::other_queue, -1, {}, {}}
                                         : StartDifference();
}

/// Every fact about the controller that a rehearsal is given, and how it is compared afterwards. A rehearsal
/// knows nothing else, so nothing enters it without being compared. The first difference in this order is
/// reported.
struct Fact {
  void (*take)(const ControllerState& of, const Catalog&, ControllerState& into);
  StartDifference (*compare)(const Comparison&);
};
constexpr std::array<Fact, 10> facts{{
    {take_axes, compare_axes},
    {take_params, compare_params},
    {take_outputs, compare_outputs},
    {take_inputs, compare_inputs},
    {take_analog, compare_analog},
    {take_readouts, compare_readouts},
    {take_variables, compare_variables},
    {take_programs, compare_programs},
    {take_sizes, compare_sizes},
    {take_queue, compare_queue},
}};

ControllerState sent_to_rehearsals(const ControllerState& from, const Catalog& catalog) {
  ControllerState into;
  into.now.slot_bytes_used.fill(-1);
  for (const Fact& fact : facts) fact.take(from, catalog, into);
  return into;
}

/// A rehearsal whose run has begun can differ at most in the axes' initial state.
StartDifference compare(const Comparison& c, const Rehearsals::Scene& scene, const BenchView& bench) {
  const bool known = scene.switches.has_value();
  const bool same_bench = known == bench.present && (!known || *scene.switches == bench.switches);
  for (const Fact& fact : facts) {
    if (const StartDifference start = fact.compare(c); start != StartDifference()) return start;
    if (c.left) return {};
    if (!same_bench) return {StartMatch::other_bench, -1, {}, {}};
  }
  return {};
}

}  // namespace

std::string_view why_not_rehearse_now(const Snapshot& now, const Catalog& catalog) {
  if (!commands_wait(now, catalog)) return {};
  return "Let the commands in the controller's queues run, or press Stop; then simulate. Their text cannot "
         "be read.";
}

void Rehearsals::start(const Language& language, std::string text, const RehearseOptions& requested,
                       const ControllerState& from, const BenchView& bench, const Catalog& catalog,
                       Worker& worker) {
  const int slot = requested.slot;
  prepared_.erase(slot);
  if (!running_.insert(slot).second) return;
  Scene scene{std::make_shared<const ControllerState>(sent_to_rehearsals(from, catalog)), std::nullopt};
  if (bench.present) scene.switches = bench.switches;
  RehearseOptions options = rehearse_from(scene.state, bench, catalog);
  options.slot = slot, options.for_seconds = requested.for_seconds,
  options.track_every_s = requested.track_every_s;
  worker.run(
      [&language, text = std::move(text), options = std::move(options), scene = std::move(scene)]() mutable {
        auto result = language.rehearse(text, options);
        Outcome outcome{std::move(text), std::move(result), std::move(scene)};
        outcome.fills.insert(options.slot);
        for (const auto& [filled, commands] : language.analyse(outcome.text, options.slot).listing)
          outcome.fills.insert(filled);
        return outcome;
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
    const Comparison made{*outcome.result, *outcome.scene.state, now, catalog, outcome.fills, held, left};
    const StartDifference start = compare(made, outcome.scene, bench);
    if (start == outcome.start) continue;
    outcome.start = start;
    ++version_;
  }
}

}  // namespace hw::gui
