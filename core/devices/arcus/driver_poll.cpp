// One round of status, and what it means. While something moves: where it is, as often as the wire bears; at
// rest everything, five times a second.
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {
namespace {

constexpr int io_every = 4;  // rounds in motion between two looks at inputs, outputs and threads

}  // namespace

Task<Result<>> ArcusDriver::poll(Round round) {
  if (!talk_.is_open()) co_return talk_.no_connection();
  if (round == Round::stopping) co_return co_await see_whether_it_stands();
  ++round_;
  const RestartWatch::Look look = watch_.begin_look();
  auto motion = co_await read_motion(Priority::poll);
  if (!motion) co_return motion;
  auto returned = co_await borrowed_.give_back();
  if (!returned) co_return returned;
  auto fed = co_await feed();
  if (!fed) co_return fed;
  if (std::exchange(io_due_, false) || watch_.in_doubt() || !any_moving() || round_ % io_every == 0) {
    auto io = co_await read_io(Priority::poll);
    if (!io) co_return io;
    auto threads = co_await read_threads(false, Priority::poll);
    if (!threads) co_return threads;
    auto looked = co_await watch_.look_at_motors(look);
    if (!looked) co_return looked;
  }
  auto watched = co_await readouts_.read_watched();
  if (!watched) co_return watched;
  if (!any_moving()) {
    auto rest = co_await read_at_rest();
    if (!rest) co_return rest;
  }
  setup_.show_own_speeds();
  show_worst();
  co_return Result<>();
}

Task<Result<>> ArcusDriver::see_whether_it_stands() {
  auto seen = co_await read_motion(Priority::stop);
  if (!seen) co_return seen;
  if (halting_) co_return co_await read_threads(true, Priority::stop);
  co_return Result<>();
}

// As often as the wire bears; where bytes take no time (TCP, USB, in process) a hundred rounds a second.
Duration ArcusDriver::moving_period() const {
  constexpr std::size_t bytes_of_a_round = 60;
  constexpr Duration without_wire = Millis(10);
  const Duration round = talk_.is_open() ? talk_.station()->wire_time(bytes_of_a_round) : Duration::zero();
  if (round == Duration::zero()) return without_wire;
  return std::max(Duration::zero(), round - (console_.scheduler.now() - round_began_));
}

// Each of them is looked at for a restart: one that was not would hide it from the next.
Task<Result<>> ArcusDriver::read_motion(Priority priority) {
  const RestartWatch::Look look = watch_.begin_look();
  auto read = co_await read_whole_motion(priority);
  if (read) watch_.look_at_counters(look);
  co_return read;
}

// Where an answer was missing in between, what was read before and behind it may be of two controllers: one
// before its restart, and one behind it.
Task<Result<>> ArcusDriver::read_whole_motion(Priority priority) {
  for (const bool again : {false, true}) {
    auto read = co_await read_counters(priority);
    if (read) read = co_await read_loop(priority);
    if (!read || again || watch_.motion_is_whole()) co_return read;
  }
  co_return Result<>();
}

// Four questions, each answered for all axes.
Task<Result<>> ArcusDriver::read_counters(Priority priority) {
  round_began_ = console_.scheduler.now();
  const auto axes = ix(console_.axes());
  std::size_t fields = axes;
  for (const std::string_view id : console_.forms.behind_status) fields += id.empty() ? 0 : 1;
  const Instant asked_at = console_.scheduler.now();
  auto status = co_await talk_.ask_numbers(std::string(console_.forms.status), fields, priority);
  if (!status) co_return fail(status.error());
  watch_.first_answer_came();
  auto positions = co_await talk_.ask_numbers(std::string(console_.forms.positions), axes, priority);
  if (!positions) co_return fail(positions.error());
  const Instant seen_at = talk_.asked_at();  // the answer, or what is asked behind it, may have come late
  auto encoders = co_await talk_.ask_numbers(std::string(console_.forms.encoders), axes, priority);
  if (!encoders) co_return fail(encoders.error());
  auto speeds = co_await talk_.ask_numbers(std::string(console_.forms.speeds), axes, priority);
  if (!speeds) co_return fail(speeds.error());
  if (asked_at < motion_asked_at_) co_return Result<>();  // overtaken: a stop's own round is newer
  motion_asked_at_ = asked_at;
  take_status(*status);
  for (int i = 0; i < console_.axes(); ++i) {
    AxisState& axis = console_.draft.axes[i];
    const Steps position((*positions)[ix(i)]);
    const Steps move = position - axis.position;
    const bool changed = axis.position_known && move != Steps(0);
    axis.position = position;
    axis.position_known = true;
    axis.seen_at = seen_at;
    axis.has_encoder = true;
    axis.encoder = Steps((*encoders)[ix(i)]);
    axis.speed = Pps(std::abs(static_cast<double>((*speeds)[ix(i)])));
    if (changed) minds_[ix(i)].turned = static_cast<std::int8_t>(move > Steps(0) ? 1 : -1);
    if (runs(i)) code_.axis_moves();
    show_axis(i, asked_at);
  }
  co_return Result<>();
}

void ArcusDriver::take_status(const std::vector<std::int64_t>& words) {
  const StatusBits& bits = console_.model().status;
  std::uint64_t limits = 0;
  for (int i = 0; i < console_.axes(); ++i)
    limits = limits << 2 | std::uint64_t{has_bit(words[ix(i)], bits.minus_limit)} << 1 |
             std::uint64_t{has_bit(words[ix(i)], bits.plus_limit)};
  const bool limits_agree = limits_look_.agrees(limits, talk_.times_cleaned());
  for (int i = 0; i < console_.axes(); ++i) {
    const std::int64_t word = words[ix(i)];
    minds_[ix(i)].status = word;
    AxisState& axis = console_.draft.axes[i];
    axis.limit_minus = has_bit(word, bits.minus_limit);
    axis.limit_plus = has_bit(word, bits.plus_limit);
    axis.home = has_bit(word, bits.home);
    axis.alarm = has_bit(word, bits.alarm);
    axis.limits_known = limits_agree;
    axis.phase = has_bit(word, bits.accelerating)   ? Phase::accelerating
                 : has_bit(word, bits.decelerating) ? Phase::decelerating
                 : has_bit(word, bits.constant)     ? Phase::constant
                                                    : Phase::unknown;
    readouts_.put(fill(console_.forms, console_.axes() > 1 ? "MSTa" : "MST", i), word);
  }
  if (bits.latch != no_bit) readouts_.put("LATCHIN", has_bit(words[0], bits.latch));
  if (bits.index != no_bit) readouts_.put("INDEX", has_bit(words[0], bits.index));
  std::size_t field = ix(console_.axes());
  for (const std::string_view id : console_.forms.behind_status) {
    if (id.empty()) continue;
    readouts_.put(id, words[field]);
    if (id == "BUF") list_.buffer_is(words[field] != 0);
    if (id == "BUFFREE") list_.places_are(static_cast<int>(words[field]));
    ++field;
  }
}

// The state of StepNLoop, of axes that have it on, or where that is not known.
Task<Result<>> ArcusDriver::read_loop(Priority priority) {
  for (int i = 0; i < console_.axes(); ++i) {
    AxisMind& mind = minds_[ix(i)];
    if (mind.loop_state == static_cast<int>(LoopState::off)) continue;
    const std::string question = fill(console_.forms, console_.forms.loop_state, i);
    const Instant asked_at = console_.scheduler.now();
    auto state = co_await talk_.ask_number(question, priority);
    if (!state) co_return fail(state.error());
    if (asked_at < mind.loop_asked_at) continue;
    mind.loop_asked_at = asked_at;
    mind.loop_state = static_cast<int>(*state);
    console_.draft.axes[i].in_counts = *state != static_cast<int>(LoopState::off);
    readouts_.put(question, *state);
    show_axis(i, asked_at);
  }
  co_return Result<>();
}

Task<Result<>> ArcusDriver::read_io(Priority priority) {
  for (const bool again : {false, true}) {
    auto inputs = co_await talk_.ask_number("DI", priority);
    if (!inputs) co_return fail(inputs.error());
    auto outputs = co_await talk_.ask_number("DO", priority);
    if (!outputs) co_return fail(outputs.error());
    auto enables = co_await talk_.ask_number("EO", priority);
    if (!enables) co_return fail(enables.error());
    const std::uint64_t lines = static_cast<std::uint64_t>(*inputs) << 16 ^
                                static_cast<std::uint64_t>(*outputs) << 8 ^
                                static_cast<std::uint64_t>(*enables);
    if (!io_look_.agrees(lines, talk_.times_cleaned())) {
      if (!again) continue;
      break;  // what was shown keeps its age
    }
    console_.draft.inputs = static_cast<std::uint32_t>(*inputs);
    console_.draft.inputs_known = (1u << console_.model().inputs) - 1;
    console_.draft.outputs = static_cast<std::uint32_t>(*outputs);
    console_.draft.outputs_known = (1u << console_.model().outputs) - 1;
    console_.draft.io_seen_at = console_.scheduler.now();
    for (int i = 0; i < console_.axes(); ++i) console_.draft.axes[i].enabled = (*enables >> i & 1) != 0;
    break;
  }
  co_return Result<>();
}

// In the middle of a long procedure: positions must not grow stale meanwhile.
Task<> ArcusDriver::stay_live() {
  if (!talk_.is_open() || console_.scheduler.now() - round_began_ < idle_period()) co_return;
  auto read = co_await read_motion(Priority::poll);
  if (read) read = co_await read_threads(false, Priority::poll);
  console_.changed();
}

// ---- what it means

bool ArcusDriver::moving(int axis) const {
  const Activity a = console_.draft.axes[axis].activity;
  return a == Activity::moving || a == Activity::jogging || a == Activity::homing || a == Activity::stopping;
}
bool ArcusDriver::any_moving() const { return console_.draft.any_axis_moving(); }

bool ArcusDriver::loop_error(int axis) const {
  const int state = minds_[ix(axis)].loop_state;
  return state >= static_cast<int>(LoopState::range_error) &&
         state <= static_cast<int>(LoopState::limit_error);
}

namespace {

bool loop_works(int state) {
  return (state >= static_cast<int>(LoopState::moving) &&
          state <= static_cast<int>(LoopState::index_homing)) ||
         state == static_cast<int>(LoopState::limit_homing);
}

Activity activity_of(int loop_state) {
  switch (static_cast<LoopState>(loop_state)) {
    case LoopState::jogging: return Activity::jogging;
    case LoopState::homing:
    case LoopState::index_homing:
    case LoopState::limit_homing: return Activity::homing;
    case LoopState::stopping:
    case LoopState::aborting: return Activity::stopping;
    default: return Activity::moving;
  }
}

}  // namespace

bool ArcusDriver::runs(int axis) const {
  const AxisMind& mind = minds_[ix(axis)];
  return says_moving(mind.status) || loop_works(mind.loop_state);
}

// What the axis does, from its status word, StepNLoop and what the console began. A command that was sent
// after the question was asked is not judged by the answer.
void ArcusDriver::show_axis(int index, Instant asked_at) {
  AxisMind& mind = minds_[ix(index)];
  AxisState& axis = console_.draft.axes[index];
  if (mind.begun_at > asked_at) return;
  if (mind.stopping) {  // until whoever stops it has seen it stand
    axis.activity = Activity::stopping;
    return;
  }
  if (runs(index)) {
    if (mind.ours && mind.wanted != Activity::idle)
      axis.activity = mind.wanted;
    else
      axis.activity = activity_of(mind.loop_state);
    if (axis.has_target && mind.ours)
      axis.direction = static_cast<std::int8_t>(axis.target < axis.position ? -1 : 1);
    else if (!mind.ours || mind.wanted != Activity::jogging)
      axis.direction = mind.turned;
    axis.ended_by = EndedBy::nothing;
    axis.error = AxisError::none;
    return;
  }
  if (moving(index) || axis.activity == Activity::unknown) show_ended(index);
  axis.error = error_of(index);
  axis.activity = axis.error == AxisError::none ? Activity::idle : Activity::error;
  axis.phase = Phase::unknown;
  axis.direction = 0;
}

AxisError ArcusDriver::error_of(int axis) const {
  const StatusBits& bits = console_.model().status;
  const std::int64_t word = minds_[ix(axis)].status;
  switch (static_cast<LoopState>(minds_[ix(axis)].loop_state)) {
    case LoopState::stall_error: return AxisError::stalled;
    case LoopState::range_error: return AxisError::too_far;
    case LoopState::attempt_error: return AxisError::not_corrected;
    default: break;
  }
  if (has_bit(word, bits.minus_error)) return AxisError::limit_minus;
  if (has_bit(word, bits.plus_error)) return AxisError::limit_plus;
  if (has_bit(word, bits.alarm_error)) return AxisError::alarm;
  return loop_error(axis) ? AxisError::limit : AxisError::none;
}

void ArcusDriver::show_ended(int index) {
  AxisMind& mind = minds_[ix(index)];
  AxisState& axis = console_.draft.axes[index];
  const bool was_moving = moving(index);
  if (was_moving) axis.ended_by = how_it_ended(index);
  if (was_moving && mind.wanted == Activity::homing && axis.ended_by == EndedBy::target)
    axis.trust.settle(Trust::homed, console_.scheduler.now());
  mind.ours = false;
  mind.with = 0;
  mind.wanted = Activity::idle;
  mind.ended_by = EndedBy::nothing;
  axis.has_target = false;
}

EndedBy ArcusDriver::how_it_ended(int axis) const {
  const StatusBits& bits = console_.model().status;
  const std::int64_t word = minds_[ix(axis)].status;
  if (has_bit(word, bits.plus_error) || has_bit(word, bits.minus_error)) return EndedBy::limit;
  if (has_bit(word, bits.alarm_error) || loop_error(axis)) return EndedBy::error;
  if (minds_[ix(axis)].ended_by != EndedBy::nothing) return minds_[ix(axis)].ended_by;
  if (!misses_its_target(axis)) return EndedBy::target;
  const unsigned with = minds_[ix(axis)].with;
  for (int i = 0; i < console_.axes(); ++i)  // on a straight line all end with the one that cannot go on
    if (i != axis && (with >> i & 1u) != 0 && error_of(i) != AxisError::none) return EndedBy::nothing;
  return EndedBy::elsewhere;
}

// With StepNLoop it may stand a little beside it (SLT).
bool ArcusDriver::misses_its_target(int index) const {
  const AxisState& axis = console_.draft.axes[index];
  if (!axis.has_target) return false;
  return std::abs((axis.position - axis.target).value) > (axis.in_counts ? loop_tolerance(index) : 0);
}

std::int64_t ArcusDriver::loop_tolerance(int axis) const {
  std::int64_t room = setup_.setting(Setting::loop_tolerance, axis).value_or(0);
  for (const SettingFact& fact : console_.model().settings)
    if (fact.id == Setting::loop_tolerance && room == 0) room = fact.factory;  // not read yet
  return room;
}

namespace {

const char* what_happened(AxisError error) {
  switch (error) {
    case AxisError::limit_minus: return "hit its - limit";
    case AxisError::limit_plus: return "hit its + limit";
    case AxisError::limit: return "hit a limit";
    case AxisError::alarm: return "was stopped by its alarm";
    case AxisError::stalled: return "did not follow (stall)";
    case AxisError::too_far: return "stands too far off";
    case AxisError::not_corrected: return "could not be corrected";
    case AxisError::none: break;
  }
  return "";
}

}  // namespace

// Called each round: nothing here allocates while all is well.
void ArcusDriver::show_worst() {
  console_.draft.notice.clear();
  for (int i = 0; i < console_.axes(); ++i) {
    const AxisError error = error_of(i);
    if (error == AxisError::none) continue;
    console_.draft.notice = fmt::format("Axis {} {}. Clear the errors before the next move.",
                                        console_.axis_name(i), what_happened(error));
    return;
  }
  for (int i = 0; i < console_.model().programs; ++i)
    if (console_.draft.threads[ix(i)].known && console_.draft.threads[ix(i)].run == RunState::error) {
      console_.draft.notice = fmt::format("Program {} has stopped in error at line {} of its stored code.", i,
                                          console_.draft.threads[ix(i)].line);
      return;
    }
}

}  // namespace hw::arcus
