#include "core/devices/arcus/motion_status.h"

#include <cmath>

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::arcus {

Task<Result<>> MotionStatus::read(Priority priority) {
  const RestartWatch::Look look = watch_.begin_look();
  auto read = co_await read_whole(priority);
  if (read) watch_.look_at_counters(look);
  co_return read;
}

// If a reply was missed, values read before and after it may be from before and after a restart.
Task<Result<>> MotionStatus::read_whole(Priority priority) {
  for (const bool again : {false, true}) {
    auto read = co_await read_counters(priority);
    if (read) read = co_await read_loops(priority);
    for (int i = 0; read && i < console_.axes(); ++i) motions_.show(i, asked_at_);
    if (!read || again || watch_.motion_is_whole()) co_return read;
  }
  co_return Result<>();
}

// Four questions, each answered for all axes.
Task<Result<>> MotionStatus::read_counters(Priority priority) {
  round_began_ = console_.scheduler.now();
  const auto axes = ix(console_.axes());
  const Instant asked_at = console_.scheduler.now();
  auto status = co_await conversation_.ask_numbers(std::string(console_.forms.status),
                                                   fields_of_status(console_), priority);
  if (!status) co_return fail(status.error());
  limits_.take(*status, conversation_.asked_at());
  watch_.first_answer_came();
  auto positions = co_await conversation_.ask_numbers(std::string(console_.forms.positions), axes, priority);
  if (!positions) co_return fail(positions.error());
  const Instant seen_at = conversation_.asked_at();  // this reply or a later one may have come late
  auto encoders = co_await conversation_.ask_numbers(std::string(console_.forms.encoders), axes, priority);
  if (!encoders) co_return fail(encoders.error());
  auto speeds = co_await conversation_.ask_numbers(std::string(console_.forms.speeds), axes, priority);
  if (!speeds) co_return fail(speeds.error());
  if (asked_at < asked_at_) co_return Result<>();  // a stop's own round has overtaken this one
  asked_at_ = asked_at;
  take_status(*status);
  for (int i = 0; i < console_.axes(); ++i) {
    AxisState& axis = console_.snapshot.axes[i];
    const Steps position((*positions)[ix(i)]);
    const Steps move = position - axis.position;
    const bool was_known = axis.position_known;
    axis.position = position;
    axis.position_known = true;
    axis.seen_at = seen_at;
    axis.has_encoder = true;
    axis.encoder = Steps((*encoders)[ix(i)]);
    axis.speed = Pps(std::abs(static_cast<double>((*speeds)[ix(i)])));
    if (was_known) motions_.turned(i, move);
    motions_.seen(i);
    if (motions_.runs(i)) code_.axis_moves();
  }
  co_return Result<>();
}

void MotionStatus::take_status(const std::vector<std::int64_t>& words) {
  const StatusBits& bits = console_.model().status;
  for (int i = 0; i < console_.axes(); ++i) {
    const std::int64_t word = words[ix(i)];
    motions_.status_is(i, word);
    AxisState& axis = console_.snapshot.axes[i];
    axis.home = has_bit(word, bits.home);
    axis.alarm = has_bit(word, bits.alarm);
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

// Reads the StepNLoop state of axes that have it on, or where that is unknown. Only a whole round tells
// whether an axis is at rest: its position must be of the same round.
Task<Result<>> MotionStatus::read_loops(Priority priority) {
  for (int i = 0; i < console_.axes(); ++i) {
    if (motions_.loop_is_off(i)) continue;
    const std::string question = fill(console_.forms, console_.forms.loop_state, i);
    const Instant asked_at = console_.scheduler.now();
    auto state = co_await conversation_.ask_number(question, priority);
    const bool has_none = !state && state.error().kind == FaultKind::refused;  // a firmware without StepNLoop
    if (has_none) state = static_cast<std::int64_t>(LoopState::off);
    if (!state) co_return fail(state.error());
    if (motions_.take_loop(i, *state, asked_at)) readouts_.put(question, *state);
  }
  co_return Result<>();
}

// Called after a command that moves had no clear reply. Reads the state; nothing is sent again.
Task<Fault> MotionStatus::after_doubt(Fault why, std::string_view sent) {
  Fault fault = std::move(why);
  if (fault.kind != FaultKind::no_answer && fault.kind != FaultKind::garbled) co_return fault;
  auto seen = co_await read(Priority::intent);
  std::string where;
  for (int i = 0; seen && i < console_.axes(); ++i)
    where += fmt::format("{}{} {} at {}", i ? ", " : "", console_.axis_name(i),
                         motions_.reports_motion(i) ? "is moving" : "is at rest",
                         console_.snapshot.axes[i].position.value);
  fault.what = fmt::format("{} had no clear reply.", sent);
  fault.done = "It was sent once and is not repeated.";
  fault.advice = seen ? fmt::format("The state was read again: {}.", where)
                      : "The state could not be read either. Check the axis before you go on.";
  co_return fault;
}

}  // namespace hw::arcus
