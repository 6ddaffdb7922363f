#include "core/devices/vme58/servo_loops.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::vme58 {
namespace {

/// Errors up to this many counts are normal for working loops: a few degrees of the usual encoders. Over
/// more, the motor moves its stage visibly, at full output. A greater deadband raises the limit.
constexpr std::int64_t large_error = 100;

}  // namespace

/// The board does not show HD: it is known only if the console has set it.
std::int64_t ServoLoops::deadband(int axis) const {
  const auto set = values_.known(axis, "HD");
  return set && *set > 0 ? *set : usual_deadband;
}

void ServoLoops::know(int axis, std::optional<bool> closed) {
  if (!is_servo(axis)) return;
  at(axis).closed = closed;
  AxisState& state = snapshot_.axes[axis];
  state.enabled = closed.value_or(true);
  const Loop place = at(axis).place.place();
  state.loop = !closed ? Loop::unknown : *closed ? place : Loop::open;
}

void ServoLoops::look(int i, Instant when, bool turns) {
  if (!is_servo(i)) return;
  Axis& servo = at(i);
  AxisState& axis = snapshot_.axes[i];
  const std::int64_t off = std::abs((axis.command - axis.encoder).value), band = deadband(i);
  servo.place.look(when, turns, off, band);
  if (turns) servo.settling = servo.goes_to_place;
  axis.far_off = off > std::max(large_error, band);
  know(i, servo.closed);
  if (axis.loop == Loop::in_place && axis.ended_by == EndedBy::not_in_place)
    axis.ended_by = EndedBy::target;  // the axis arrived late
}

void ServoLoops::goes_to_place(int axis, bool it_does) {
  at(axis).goes_to_place = it_does;
  at(axis).settling = at(axis).settling && it_does;
}

void ServoLoops::begins(int axis, bool to_a_place) {
  at(axis).goes_to_place = to_a_place;
  at(axis).settling = false;
}

void ServoLoops::begins_to_settle(int axis) {
  at(axis).place.begin(wire_.now());
  at(axis).settling = true;
  snapshot_.axes[axis].ended_by = EndedBy::nothing;
  know(axis, at(axis).closed);
}

bool ServoLoops::settles(int axis) const {
  return at(axis).settling && at(axis).place.undecided() && at(axis).closed != false;
}

EndedBy ServoLoops::judged(int i, EndedBy ended_by) {
  Axis& servo = at(i);
  const bool came = std::exchange(servo.settling, false) && ended_by == EndedBy::target;
  if (!came || servo.closed == false || servo.place.place() != Loop::off_place) return ended_by;
  next_.asks_loops();
  const AxisState& axis = snapshot_.axes[i];
  wire_.report(Notice::Kind::warning,
               fmt::format("{0} did not reach its target: 2 s after its command ended, its encoder is at "
                           "{1}, {2} counts from there. {3}",
                           catalog_.axes[ix(i)].name, axis.encoder.value,
                           std::abs((axis.command - axis.encoder).value),
                           values_.drives(i) ? "Check whether something blocks it, and check its gains."
                                             : "Nothing drives it: its gains KP and KI read 0."));
  return EndedBy::not_in_place;
}

bool ServoLoops::warn_of_closing(const TextCommand& command) {
  const int axis = command.context.axis;
  if (command.context.mode != where::single || !snapshot_.axes[axis].far_off) return false;
  const auto closed = at(axis).closed;
  const bool gain = command.is(Op::KP) || command.is(Op::KI);
  const bool above_zero = !command.numbers.empty() && command.numbers.front().value_or(0) > 0;
  const bool drives = gain && above_zero && closed != false && !values_.drives(axis);
  if (!drives && !(command.is(Op::HN) && closed != true)) return false;
  wire_.report(Notice::Kind::warning, fmt::format("{} was sent while the encoder of {} was {} counts from "
                                                  "its command: the motor may be driven there at once.",
                                                  command.text, catalog_.axes[ix(axis)].name,
                                                  std::abs(snapshot_.axes[axis].following_error().value)));
  return true;
}

void ServoLoops::forget() {
  axes_ = {};
  for (int i = 0; i < static_cast<int>(catalog_.axes.size()); ++i) know(i, std::nullopt);
}

}  // namespace hw::vme58
