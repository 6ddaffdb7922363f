#include "core/devices/vxm/positions.h"

#include "core/devices/vxm/facts.h"

namespace hw::vxm {

// Z and T are answered at standstill only.
Task<Result<>> Positions::read(Priority priority, bool at_rest, bool and_a_signal) {
  for (int i = 0; i < console_.snapshot.axis_count; ++i) {
    if (i >= motors_per_controller && (!at_rest || !identification_.has_slave())) break;
    if (i == 1 && and_a_signal) {
      auto asked = co_await signals_.ask_next(priority);
      if (!asked) co_return asked;
    }
    auto position = co_await conversation_.position(i + 1, priority);
    if (!position) co_return fail(position.error());
    show(i, *position);
    auto inputs = co_await signals_.glance(priority);
    if (!inputs) co_return inputs;
  }
  if (and_a_signal) (void)signals_.confirm();
  co_return Result<>();
}

void Positions::show(int index, Steps position) {
  AxisState& axis = console_.snapshot.axes[index];
  const MotorReadings::Change change = readings_.take(index, axis, position, conversation_.asked_at());
  const bool program_runs = under_way_.program_runs(), moves = under_way_.job().active();
  if (program_runs && (change.begun || change.reversed)) program_has_begun_a_way(change);
  if (program_runs && !moves) {  // motions of a program show in positions only
    constexpr Duration seems_moving = Millis(150);
    const bool turns = readings_.has_turned_within(seems_moving, index);
    axis.ramp = 0;  // the program's own speeds are unknown
    if (change.moved) axis.direction = static_cast<std::int8_t>(position > axis.position ? 1 : -1);
    if (!turns) axis.direction = 0;
    axis.activity = !turns ? Activity::idle : ramp_.is_expected() ? Activity::stopping : Activity::moving;
  } else if (!moves && axis.activity != Activity::error) {
    axis.activity = Activity::idle;
    axis.direction = 0;
    axis.ramp = 0;
  }
  axis.position = position;
  axis.position_known = true;
  axis.seen_at = conversation_.asked_at();  // the answer may have come late
  signals_.forget_doubtful();
}

/// A program begins a motion, so no hold is on.
void Positions::program_has_begun_a_way(const MotorReadings::Change& way) {
  hold_.something_begins();
  if (way.reversed) ramp_.saw_one_turn_round(way.since);
  if (ramp_.is_expected() || hold_.is_known()) return;
  hold_.is_seen_off();
}

void Positions::are_zero() {
  for (int i = 0; i < console_.snapshot.axis_count; ++i)
    console_.snapshot.axes[i].trust.settle(Trust::set, console_.scheduler.now());
}

}  // namespace hw::vxm
