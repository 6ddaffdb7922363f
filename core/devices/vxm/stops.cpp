#include "core/devices/vxm/stops.h"

#include <fmt/core.h>

namespace hw::vxm {

Task<Result<>> Stops::send(const StopOrder& order) {
  const bool deaf = presence_.is_unknown() || conversation_.station()->statistics().misses_in_a_row > 1;
  if (order.times_sent > 1 && deaf) {  // without a reply: an unfinished command may have swallowed the stop
    auto ended = co_await conversation_.transmit("\r", Priority::stop);
    if (!ended) co_return ended;
  }
  if (order.what == StopOrder::What::tool) co_return co_await switch_tool_off();
  if (presence_.is_unknown()) co_return co_await stop_blind(order);
  if (presence_.is_local()) co_return co_await stop_local();
  if (presence_.is_halted()) co_return co_await kills_.kill(false);
  if (under_way_.job().active()) co_return co_await stop_leg(order);
  if (under_way_.program_runs()) co_return co_await stop_program(order);
  if (under_way_.killed_at() > order.first_sent_at) co_return Result<>();  // K has ended everything since
  if (order.at_once) co_return co_await kills_.kill(false);
  co_return co_await stop_unknown();
}

// K ends all that runs and switches the outputs off. The stop of a run ends with K, and goes first.
Task<Result<>> Stops::switch_tool_off() {
  if (presence_.is_local()) co_return co_await stop_local();
  if (presence_.is_unknown() || under_way_.busy()) co_return Result<>();
  co_return co_await kills_.kill(true);
}

// The state of the controller is unknown: H might switch a hold off as well as on, and K costs steps.
Task<Result<>> Stops::stop_blind(const StopOrder& order) {
  if (order.what == StopOrder::What::jog && under_way_.program_runs()) co_return Result<>();
  if (under_way_.job().concerns(order)) under_way_.job().note_stop();
  if (order.at_once) co_return co_await kills_.kill(false);
  co_return co_await stop_unknown();
}

// As far as known, nothing runs. In Local mode D is answered; nothing may be sent into that reply.
Task<Result<>> Stops::stop_unknown() {
  const Instant sent_at = console_.scheduler.now();
  auto sent = co_await conversation_.transmit("D", Priority::stop);
  if (!sent || !conversation_.station()) co_return sent;
  auto waited = co_await conversation_.station()->pause(conversation_.station()->wire_time(4) + Millis(2));
  if (!waited || conversation_.received_at() <= sent_at) co_return waited;
  co_return co_await conversation_.wait_for_quiet();
}

// K is dropped in Local mode. F disables the jog buttons.
Task<Result<>> Stops::stop_local() {
  auto sent = co_await conversation_.transmit("F", Priority::stop);
  if (!sent) co_return sent;
  presence_.was_sent_on_line();
  co_return co_await kills_.kill(false);
}

Task<Result<>> Stops::stop_leg(const StopOrder& order) {
  const bool concerned = under_way_.job().concerns(order);
  if (!concerned && order.what != StopOrder::What::jog) {
    for (const Leg& leg : under_way_.job().drop_later_legs(order.axis))
      if (order.axis >= 0 && leg.second_axis >= 0)
        console_.report(Notice::Kind::warning,
                        fmt::format("Motors {} and {} were to move together: neither moves now.",
                                    leg.axis + 1, leg.second_axis + 1));
  }
  if (!concerned) co_return Result<>();
  under_way_.job().note_stop();
  show_stopping();
  if (hold_switch_.keeps_our_move()) co_return co_await kills_.kill(true);  // H would let it begin
  if (order.at_once) co_return co_await kills_.kill(false);
  co_return co_await ramp_down();
}

Task<Result<>> Stops::ramp_down() {
  ramp_.expect();
  co_return co_await conversation_.transmit("D", Priority::stop);
}

// Holds the program, ramps its motor down, and sends K once the motor stands. H would release a held program:
// if the program stands when its stop comes, no H is sent unless it continues.
Task<Result<>> Stops::stop_program(const StopOrder& order) {
  if (order.what == StopOrder::What::jog) co_return Result<>();
  const auto is_held = [this] { return console_.snapshot.program.run == RunState::held; };
  if (is_held() || ramp_.is_over()) co_return co_await kills_.kill(true);
  if (order.at_once) co_return co_await kills_.kill(false);
  ramp_.expect_of_program();
  if (!ramp_.holds() && ramp_.must_be_seen_first()) co_return co_await ramp_down();
  if (!ramp_.holds()) {
    auto held = co_await hold_switch_.transmit("H", true, Priority::stop);
    if (!held || !conversation_.station()) co_return held;
    ramp_.was_held();
    // Between two commands the hold is reported at once, and D into that report would be an overrun.
    auto waited = co_await conversation_.station()->pause(conversation_.station()->wire_time(2) + Millis(1));
    if (!waited) co_return waited;
    if (is_held()) co_return co_await kills_.kill(true);
  }
  if (!under_way_.program_runs()) co_return Result<>();  // it has ended by itself
  co_return co_await ramp_down();
}

void Stops::show_stopping() {
  for (const int index : {under_way_.job().leg().axis, under_way_.job().leg().second_axis})
    if (index >= 0 && console_.snapshot.axes[index].activity != Activity::idle)
      console_.snapshot.axes[index].activity = Activity::stopping;
}

// A command cut short by it is stored and not run.
LastWill Stops::last_will() { return {{Millis(0), "\rD"}}; }

StopProgress Stops::progress(const StopOrder& order) {
  if (presence_.is_halted()) return StopProgress::stands();  // nothing continues until K
  const bool ramps_by_words =
      under_way_.job().active() && ramp_.is_expected();  // the effect of other stops shows in the reply
  if (order.what == StopOrder::What::words && !ramps_by_words) return StopProgress::stands();
  if (under_way_.job().active()) {
    if (!under_way_.job().concerns(order)) return StopProgress::stands();
    if (under_way_.job().is_leg_over()) return StopProgress::wait();  // the next round reads where it ended
    return order.at_once || hold_switch_.keeps_our_move() ? StopProgress::again() : ramp_.watch();
  }
  if (under_way_.program_runs() && order.what != StopOrder::What::jog)
    return order.at_once ? StopProgress::again() : ramp_.watch_program();
  return StopProgress::stands();
}

}  // namespace hw::vxm
