#include "core/devices/vme58/stops.h"

#include <fmt/core.h>

#include "core/device/driver_faults.h"
#include "core/devices/vme58/moves.h"
#include "core/devices/vme58/text_meaning.h"

namespace hw::vme58 {
namespace {

constexpr Duration free_look = std::chrono::microseconds(500);
constexpr Duration ring_patience = Millis(5);  // a text cut short by the stop may still be there

}  // namespace

// ---- sending

Task<Result<>> Stops::send(StopOrder order) {
  using What = StopOrder::What;
  if (!wire_.is_open()) co_return stop_cannot_reach("board", "Switch the power of the drives off.");
  forget_rejection(snapshot_);
  if (order.what == What::words) co_return co_await stop_by_text(std::move(order.words));
  co_return co_await stop_motion(order.axis, order.at_once, order.what == What::jog);
}

/// ST of one axis empties only its own queue: the rest of a program, or commands in the queues of AA and AM,
/// would move it again.
bool Stops::stops_alone(int axis) const {
  return !motions_.in_group(axis) && !programs_.is_running() && !snapshot_.feed.running;
}

// A jog stop concerns only the jogging axis: other axes, and commands waiting for this one, continue.
Task<Result<>> Stops::stop_motion(int axis, bool at_once, bool jog) {
  const bool recorded = selection_.recording(), known = conversation_.is_known();
  const bool one = axis >= 0 && !at_once && !widened_ && !motions_.moves_in_group(axis) && !recorded;
  const bool alone = one && known && (jog || stops_alone(axis));
  if (one && !alone)
    wire_.report(
        Notice::Kind::info,
        known ? fmt::format("A program or a text may move {} again, so all axes were stopped.", name(axis))
              : fmt::format("The command that moves {} is not known yet, so all axes were stopped.",
                            name(axis)));
  if (axis >= 0 && at_once && !widened_)
    wire_.report(Notice::Kind::info, "The board's only stop without a ramp, KL, stops every axis.");
  if (!alone) programs_.end(at_once ? EndedBy::abort : EndedBy::stop);
  stopping(alone ? axis : -1, at_once);
  widened_ = widened_ || (axis >= 0 && !alone);
  if (alone) {
    std::string selector = "A" + name(axis);
    const auto stopped = co_await stop_axis(std::move(selector));
    if (!stopped) co_return fail(stopped.error());
    widened_ = !*stopped;
    co_return Result<>();
  }
  const std::string_view word = at_once ? "KL" : "SA";
  auto stopped = co_await all_stop_.send(word);
  if (stopped && recorded)
    (void)co_await conversation_.select_again(Priority::stop);  // on failure, the next text selects it
  co_return stopped;
}

/// Sent like the console's own stops, with exactly the meaning of its words. The axis that it selects is
/// noted now, and sent to the board with the next text.
Task<Result<>> Stops::stop_by_text(std::string text) {
  const bool recorded = selection_.recording();
  Context context = selection_.context();
  const auto commands = read_commands(text, context);
  selection_.set(context);
  if (recorded && !selection_.recording()) next_.awaits_queues();
  for (const TextCommand& command : commands) {
    if (selects(command)) selection_.lose();
    programs_.note_stop(command);
    effects_.note(command);
  }
  next_.asks_flags();
  Result<> all;
  for (const TextCommand& command : commands) {
    if (!stops_motion(command.fact->op)) continue;
    Result<> stopped;
    if (command.is(Op::ST)) {
      std::string selector = command.context.selector();
      const auto sent = co_await stop_axis(std::move(selector));
      if (!sent) stopped = fail(sent.error());
      widened_ = widened_ || (sent && !*sent);
      all_stop_.another_was_sent();
    } else {
      stopped = co_await all_stop_.send(command.fact->letters);
    }
    if (all) all = std::move(stopped);
  }
  co_return all;
}

// The mailbox has no place for an axis: ST goes through the ring, if that is free. In AA and AM it stops the
// axes moved by their queue. False: all axes were stopped.
Task<Result<bool>> Stops::stop_axis(std::string selector) {
  if (conversation_.is_known()) {
    auto free = co_await conversation_.is_taken(Priority::stop);
    const Instant give_up = wire_.now() + ring_patience;
    while (free && !*free && wire_.now() < give_up) {
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
  wire_.report(Notice::Kind::warning,
               fmt::format("The board accepts no command for {} alone now, so all axes were stopped.",
                           group ? "the axes of " + selector : "axis " + selector.substr(1)));
  stopping(-1, false);
  auto stopped = co_await all_stop_.send("SA");
  if (!stopped) co_return fail(stopped.error());
  co_return false;
}

// The second SA stops motions that the board may just have taken out of its ring.
LastWill Stops::last_will() const {
  std::vector<BusCycle> cycles;
  append_mail(cycles, "SA", wire_.enabled());
  return {{Millis(0), {}, cycles}, {Millis(100), {}, cycles}};
}

void Stops::stopping(int axis, bool at_once) {
  for (int i = 0; i < static_cast<int>(catalog_.axes.size()); ++i)
    if (axis < 0 || i == axis) effect_.stop_sent(i);
  speeds_.forget_put(axis);
  motions_.stopping(axis, at_once);
}

// ---- effect

/// A stop has had no effect while none of its axes slows down. An axis slowed briefly by its own motion soon
/// regains its speed, and an axis of a straight-line move may show its share of the ramp late.
StopProgress Stops::progress(const StopOrder& order) {
  const bool words = order.what == StopOrder::What::words;
  if (words && !order.stops_all() && !widened_) return StopProgress::stands();  // sent through the ring
  const int axis = widened_ ? -1 : order.axis;
  if (axis < 0 && all_stop_.owes_ring()) return StopProgress::again();
  StopEffect::Seen seen = effect_.look(axis, order.at_once);
  const bool jog = order.what == StopOrder::What::jog && axis >= 0;
  if (seen.turns && !seen.slows && jog && !stops_alone(axis)) {
    motions_.moved_by_others(axis);
    seen.turns = false;
  }
  if (!seen.turns && axis < 0) {
    const AllStop::Behind behind = all_stop_.behind();
    if (behind == AllStop::Behind::waits) return without_effect(axis);
    if (behind == AllStop::Behind::not_known) return StopProgress::wait();
  }
  if (!seen.turns && !order.confirmed) return StopProgress::again();  // some motions show nothing
  if (!seen.turns || (seen.overdue && order.at_once)) stands(axis);
  if (!seen.turns) return StopProgress::stands();
  if (seen.overdue && order.at_once)
    return StopProgress::failed(Fault(FaultKind::controller, "Stop was sent, but the board still moves.",
                                      "KL was sent, which stops without a ramp.",
                                      "Switch the power of the drives off."));
  if (seen.slows) return StopProgress::wait();
  if (seen.overdue) return StopProgress::at_once();
  return without_effect(axis);
}

StopProgress Stops::without_effect(int axis) {
  if (axis < 0) {
    all_stop_.without_effect();
    return StopProgress::again();
  }
  widened_ = true;
  wire_.report(Notice::Kind::warning,
               fmt::format("Axis {} does not slow down after ST, so all axes are stopped.", name(axis)));
  return StopProgress::again();
}

void Stops::stands(int axis) {
  if (axis < 0) widened_ = false;
  readings_.forget_command_error();  // caused by text withdrawn in part
  effect_.forget(axis);
  motions_.stands(axis);
}

void Stops::forget() {
  widened_ = false;
  effect_.forget(-1);
}

}  // namespace hw::vme58
