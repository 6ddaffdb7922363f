// Stops: what is sent, and what shows that it takes effect. A stop of all axes goes through the mailbox and
// empties the queues too; one of one axis through the ring, where that is free.
#include <cmath>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"
#include "core/devices/vme58/text_meaning.h"

namespace hw::vme58 {
namespace {

constexpr Duration free_look = std::chrono::microseconds(500);
constexpr Duration ring_patience = Millis(5);  // what a stop has cut short may just have been put there
constexpr Duration effect_time = Millis(60);   // so that what is in vain is seen within 100 ms
constexpr Duration kill_time = std::chrono::seconds(2);  // KL is sent again for so long
constexpr Duration longest_rest = Millis(400);  // where the queues do not answer: what waits begins by then
constexpr double longest_shape = 3;  // a ramp of PN10 against a straight one, and a little
constexpr Duration ramp_margin = std::chrono::seconds(1);

}  // namespace

// ---- what is sent

Task<Result<std::string>> Vme58Driver::stop(const StopOrder& order) {
  using What = StopOrder::What;
  if (order.what == What::broadcast) co_return std::string();
  if (!wire_.is_open())
    co_return fail(FaultKind::lost, "Stop does not reach the board: there is no connection.",
                   "Nothing was sent.", "Switch the power of the drives off.");
  forget_rejection();
  Result<> sent;
  if (order.what == What::words)
    sent = co_await stop_by_text(order.words);
  else
    sent = co_await stop_motion(order.axis, order.at_once, order.what == What::jog);
  if (!sent) co_return fail(sent.error());
  co_return std::string();
}

/// ST of one axis empties its own queue only: what a program still says, or what waits in those of AA and AM,
/// would move it again.
bool Vme58Driver::stops_alone(int axis) const {
  return !minds_[ix(axis)].in_group && draft_.program.run != RunState::running && !draft_.feed.running;
}

// What a jog moves stops; the other axes, and what waits for this one, go on.
Task<Result<>> Vme58Driver::stop_motion(int axis, bool at_once, bool jog) {
  const bool recorded = selection_.recording();
  const bool one = axis >= 0 && !at_once && !widened_ && minds_[ix(axis)].group == 0 && !recorded;
  const bool alone = one && conversation_.is_known() && (jog || stops_alone(axis));
  if (one && !alone)
    tell(
        Notice::Kind::info,
        conversation_.is_known()
            ? fmt::format("A program or a text may move {} again, so all axes were stopped.", axis_name(axis))
            : fmt::format("What moves {} is not known yet, so all axes were stopped.", axis_name(axis)));
  if (axis >= 0 && at_once && !widened_)
    tell(Notice::Kind::info, "The board's only stop without a ramp, KL, stops every axis.");
  if (!alone) end_program(at_once ? EndedBy::abort : EndedBy::stop);
  stopping(alone ? axis : -1, at_once);
  widened_ = widened_ || (axis >= 0 && !alone);
  if (alone) {
    std::string selector = "A" + axis_name(axis);
    const auto stopped = co_await stop_axis(std::move(selector));
    if (!stopped) co_return fail(stopped.error());
    widened_ = !*stopped;
    co_return Result<>();
  }
  auto stopped = co_await stop_all(at_once ? "KL" : "SA");
  if (stopped && recorded) (void)co_await conversation_.select_again(Priority::stop);  // else with the next text
  co_return stopped;
}

/// Goes like the console's own stops, and means no more than it says. Which axis it selects is known from
/// here on; the board hears it with the next text.
Task<Result<>> Vme58Driver::stop_by_text(std::string text) {
  const bool recorded = selection_.recording();
  Context context = selection_.context();
  const auto commands = read_commands(text, context);
  selection_.set(context);
  if (recorded && !selection_.recording()) draft_.working = queues_due_ = true;
  for (const TextCommand& command : commands) {
    if (selects(command)) selection_.lose();
    note_stop_of_program(command);
    note_effects(command);
  }
  flags_wanted_ = true;
  Result<> all;
  for (const TextCommand& command : commands) {
    if (!stops_motion(command.fact->op)) continue;
    Result<> stopped;
    if (command.is(Op::ST)) {
      std::string selector = command.context.selector();
      const auto sent = co_await stop_axis(std::move(selector));
      if (!sent) stopped = fail(sent.error());
    } else {
      stopped = co_await stop_all(command.fact->letters);
    }
    if (all) all = std::move(stopped);
  }
  co_return all;
}

// The mailbox has no place for an axis: ST goes through the ring, as long as nothing stands there. In AA and
// AM it stops what their queue moves. False: all axes were stopped.
Task<Result<bool>> Vme58Driver::stop_axis(std::string selector) {
  if (conversation_.is_known()) {
    auto free = co_await conversation_.is_taken(Priority::stop);
    const Instant give_up = now() + ring_patience;
    while (free && !*free && now() < give_up) {
      auto paused = co_await wire_.pause(free_look);
      if (!paused) co_return fail(paused.error());
      free = co_await conversation_.is_taken(Priority::stop);
    }
    if (!free) co_return fail(free.error());
    if (*free) {
      std::string text = selection_.addressed(selector, "ST");
      const auto written = co_await conversation_.write(std::move(text), Priority::stop);
      if (written) co_return true;
      const FaultKind kind = written.error().kind;
      if (kind == FaultKind::lost || kind == FaultKind::stopped) co_return fail(written.error());
    }
  }
  const bool group = selector == "AA" || selector == "AM";
  tell(Notice::Kind::warning,
       fmt::format("The board takes no command for {} alone now, so all axes were stopped.",
                   group ? "the axes of " + selector : "axis " + selector.substr(1)));
  stopping(-1, false);
  auto stopped = co_await stop_all("SA");
  if (!stopped) co_return fail(stopped.error());
  co_return false;
}

/// SA, SD or KL. Through the ring too where the mailbox does nothing.
Task<Result<>> Vme58Driver::stop_all(std::string_view word) {
  if (word == "KL") doubt_killed_positions();
  queues_after_stop_ = QueuesAfterStop::not_known;
  rests_since_ = now();
  auto mailed = co_await mailbox_.mail_past_ring(word);
  const bool ring_may_do = mailed ? mailbox_deaf_ : mailed.error().kind == FaultKind::no_answer;
  if (!ring_may_do || !conversation_.is_known()) co_return mailed;
  std::string text = std::string(word) + "\n";
  auto written = co_await conversation_.write(std::move(text), Priority::stop);
  co_return written ? written : mailed;
}

void Vme58Driver::stopping(int axis, bool at_once) {
  for (int i = 0; i < axis_count(); ++i) {
    if (axis >= 0 && i != axis) continue;
    AxisMind& mind = minds_[ix(i)];
    forget_put_velocities(i);
    begins_to_creep(i, {});
    mind.at_home = AtHome::nothing;  // one that waits in a queue goes with it
    mind.servo.goes_to_place = mind.servo.settling = false;
    if (mind.slow_down) mind.slow_down->slower_at = now();
    if (!moving(i) && !mind.ours) continue;
    mind.stopping = true;
    mind.ended_by = at_once ? EndedBy::abort : EndedBy::stop;
    draft_.axes[i].activity = Activity::stopping;
  }
}

// ---- what shows of it

/// A stop is in vain while no axis of it slows down. An axis that its own motion slows down for a moment is
/// soon as fast as ever again, and one of several on a line may show its share of the ramp late.
StopProgress Vme58Driver::stop_progress(const StopOrder& order) {
  const bool words = order.what == StopOrder::What::words;
  if (words && !order.stops_all()) return StopProgress::stands();  // the ring has carried them
  const Instant at = now();
  const int axis = widened_ ? -1 : order.axis;
  bool turns = false, slows = false, overdue = false;
  for (int i = 0; i < axis_count(); ++i) {
    if ((axis >= 0 && i != axis) || !moving(i)) continue;
    const SlowDown& seen = slow_down(i);
    turns = true;
    slows = slows || at - seen.slower_at <= effect_patience(i, seen);
    const Duration extra = order.at_once ? kill_time : Duration::zero();
    overdue = overdue || at - seen.since > longest_ramp(i, seen) + extra;
  }
  if (turns && !slows && order.what == StopOrder::What::jog && axis >= 0 && !stops_alone(axis)) {
    is_anothers(axis);
    turns = false;
  }
  if (!turns && axis < 0 && queues_after_stop_ != QueuesAfterStop::empty) {
    if (queues_after_stop_ == QueuesAfterStop::wait) stopped_in_vain(axis);
    if (queues_after_stop_ == QueuesAfterStop::wait) return StopProgress::again();
    if (at - rests_since_ < longest_rest) return StopProgress::wait();
  }
  if (!turns || (overdue && order.at_once)) stands(axis);
  if (!turns) return StopProgress::stands();
  if (overdue && order.at_once)
    return StopProgress::failed(Fault(FaultKind::controller, "The board was told to stop and still moves.",
                                      "KL was sent, which stops without a ramp.",
                                      "Switch the power of the drives off."));
  if (slows) return StopProgress::wait();
  if (overdue) return StopProgress::at_once();
  stopped_in_vain(axis);
  return StopProgress::again();
}

/// A stop of all empties the queues, and one that was not obeyed leaves what waits there: between two of its
/// motions an axis rests for a moment. Asked as soon as none turns.
Task<Result<>> Vme58Driver::look_at_queues_after_stop() {
  if (queues_after_stop_ == QueuesAfterStop::empty || selection_.recording()) co_return Result<>();
  for (int i = 0; i < axis_count(); ++i)
    if (moving(i)) {
      rests_since_ = now();
      co_return Result<>();
    }
  const auto taken = co_await conversation_.is_taken(Priority::stop);
  if (!taken) co_return fail(taken.error());
  if (!*taken) co_return Result<>();
  auto asked = co_await read_queues(Priority::stop);
  if (!asked) co_return asked;
  if (queues_empty_)
    queues_after_stop_ = QueuesAfterStop::empty;
  else
    queues_after_stop_ = draft_.queue_known != 0 ? QueuesAfterStop::wait : QueuesAfterStop::not_known;
  co_return Result<>();
}

/// A text or a program has begun to move it behind its jog, and that goes on.
void Vme58Driver::is_anothers(int axis) {
  AxisMind& mind = minds_[ix(axis)];
  mind.ours = mind.stopping = false;
  mind.by_text = true;
  mind.wanted = Activity::idle;
}

/// Of an axis that turns, as the latest round shows it.
Vme58Driver::SlowDown& Vme58Driver::slow_down(int axis) {
  const std::int64_t speed = std::abs(value(axis, AxisValue::command_velocity));
  std::optional<SlowDown>& seen = minds_[ix(axis)].slow_down;
  if (!seen) seen = SlowDown{now(), now(), speed, speed};
  if (speed < seen->least) {
    seen->least = speed;
    seen->slower_at = now();
  }
  return *seen;
}

/// The board shows whole counts/s, and a rounded ramp (PN, CN) begins and ends gently: so long it may show
/// nothing.
Duration Vme58Driver::effect_patience(int axis, const SlowDown& seen) const {
  const auto acceleration =
      static_cast<double>(std::max<std::int64_t>(1, value(axis, AxisValue::acceleration)));
  return effect_time + from_seconds((20 + 2 * std::sqrt(static_cast<double>(seen.first))) / acceleration);
}

Duration Vme58Driver::longest_ramp(int axis, const SlowDown& seen) const {
  const auto acceleration =
      static_cast<double>(std::max<std::int64_t>(1, value(axis, AxisValue::acceleration)));
  return ramp_margin + from_seconds(longest_shape * static_cast<double>(seen.first) / acceleration);
}

void Vme58Driver::stopped_in_vain(int axis) {
  if (axis >= 0) {
    widened_ = true;
    tell(Notice::Kind::warning,
         fmt::format("Axis {} does not slow down behind ST, so all axes are stopped.", axis_name(axis)));
  } else if (!std::exchange(mailbox_deaf_, true)) {
    tell(Notice::Kind::warning,
         "The board has acknowledged a stop in its mailbox, and nothing came of it. From here on stops go "
         "through its command ring too.");
  }
}

// What was being stopped is shown as it is again.
void Vme58Driver::stands(int axis) {
  if (axis < 0) widened_ = false;
  readings_.forget_command_error();  // of text that was taken back half way
  for (int i = 0; i < axis_count(); ++i) {
    if (axis >= 0 && i != axis) continue;
    minds_[ix(i)].slow_down.reset();
    if (!minds_[ix(i)].stopping) continue;
    if (moving(i))
      minds_[ix(i)].stopping = false;
    else
      end_motion(i, minds_[ix(i)].ended_by);
  }
}

/// Its pulses end with KL, not its mass: a step motor stays in step only up to the speed at which it may
/// start without a ramp too.
void Vme58Driver::doubt_killed_positions() {
  for (int i = 0; i < axis_count(); ++i) doubt_killed_position(i, draft_.axes[i].speed.value);
}

void Vme58Driver::doubt_killed_position(int i, double speed) {
  const std::int64_t safe = value(i, AxisValue::base_velocity);
  if (catalog_.axes[ix(i)].switchable || speed <= static_cast<double>(safe)) return;
  if (minds_[ix(i)].slow_down && draft_.axes[i].trust.cause == Doubt::killed) return;  // it is told again
  draft_.axes[i].trust.doubt(Doubt::killed, now());
  tell(Notice::Kind::warning,
       fmt::format("Axis {} was stopped without a ramp at {:.0f} counts/s. Above {} (VB) it may have lost "
                   "steps: its position is doubtful until it is homed or set.",
                   axis_name(i), speed, safe));
}

}  // namespace hw::vme58
