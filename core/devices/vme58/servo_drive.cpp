#include "core/devices/vme58/servo_drive.h"

#include <cstdlib>

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::vme58 {

// ---- positions

Task<Result<>> ServoDrive::set_position(intent::SetPosition request) {
  if (auto may = commands_.may_talk(); !may) co_return may;
  if (std::abs(request.value.value) > position_max)
    co_return fail(FaultKind::refused,
                   fmt::format("{} lies outside the board's range, ±{}.", request.value.value, position_max),
                   "Nothing was sent.");
  auto loaded = co_await load_positions(request.axis, request.value);
  if (!loaded) co_return loaded;
  for (int i = 0; i < axes(); ++i)
    if (request.axis < 0 || request.axis == i) motions_.trust(i, Trust::set);
  co_return Result<>();
}

// LP loads both counters (decision M92): with the same number, or so that a closed loop keeps its error. The
// next reading shows which. The encoder must then read `wanted`.
Task<Result<>> ServoDrive::load_positions(int axis, Steps wanted) {
  for (int attempt = 0; attempt < 2; ++attempt) {
    auto read = co_await readings_.read_axes(Priority::intent);
    if (!read) co_return read;
    std::array<std::optional<std::int64_t>, most_axes> loaded{};
    for (int i = 0; i < axes(); ++i) {
      if (axis >= 0 && axis != i) continue;
      const bool keeps_error = loops_.is_servo(i) && loops_.closed(i) != false;
      loaded[ix(i)] = wanted.value + (keeps_error ? snapshot_.axes[i].following_error().value : 0);
      motions_.counts(i);
    }
    std::string text = load_text(axis, loaded);
    auto sent = co_await commands_.transmit(std::move(text), Priority::intent);
    if (!sent) co_return sent;
    read = co_await readings_.read_axes(Priority::intent);
    if (!read) co_return read;
    bool alike = false;
    for (int i = 0; i < axes(); ++i)
      alike = alike || (loaded[ix(i)] && *loaded[ix(i)] != wanted.value && !motions_.moving(i) &&
                        snapshot_.axes[i].encoder.value == *loaded[ix(i)]);
    if (!alike) break;
  }
  co_return Result<>();
}

std::string ServoDrive::load_text(int axis,
                                  const std::array<std::optional<std::int64_t>, most_axes>& to) const {
  if (axis >= 0) return selection_.addressed(axis, fmt::format("LP{}", *to[ix(axis)]));
  return selection_.addressed("AA", encode_list("LP", to));
}

// ---- what closes a loop

Task<Result<>> ServoDrive::may_close(int axis, intent::Closing answer, std::string state,
                                     std::string consequence) {
  auto read = co_await readings_.read_axes(Priority::intent);
  if (!read) co_return read;
  if (!snapshot_.axes[axis].far_off || answer == intent::Closing::drive) co_return Result<>();
  if (answer == intent::Closing::stay) co_return co_await take_place(axis);
  co_return fail(FaultKind::asks,
                 fmt::format("{}, and its encoder is {} counts from its command. {}", state,
                             std::abs(snapshot_.axes[axis].following_error().value), consequence),
                 "Nothing was sent.",
                 "First take its present position as its command, or let it be driven there.");
}

// Asks before closing a loop that is open or unknown: the data sheet does not say how a board treats the
// error when HN closes the loop.
Task<Result<>> ServoDrive::switch_loop(int axis, bool on, intent::Closing answer) {
  const bool was_far = snapshot_.axes[axis].far_off;
  if (on && loops_.closed(axis) != true) {
    std::string state = fmt::format("The loop of {} is open", name(axis));
    std::string consequence = "Closing it may drive the motor there at once.";
    auto may = co_await may_close(axis, answer, std::move(state), std::move(consequence));
    if (!may) co_return may;
  }
  std::string text = selection_.addressed(axis, on ? "HN" : "HF");
  motions_.counts(axis);  // the board may take the shaft position as its command
  auto sent = co_await commands_.transmit(std::move(text), Priority::intent);
  if (!sent) next_.asks_loops();
  if (!sent) co_return sent;
  loops_.know(axis, on);
  if (on && was_far) motions_.begins_to_settle(axis);
  co_return sent;
}

Task<Result<>> ServoDrive::set_power(intent::SetPower request) {
  if (auto may = commands_.may_talk(); !may) co_return may;
  for (int i = 0; i < axes(); ++i) {
    if (request.axis >= 0 && request.axis != i) continue;
    if (!catalog_.axes[ix(i)].switchable) {
      if (request.axis < 0) continue;
      co_return fail(
          FaultKind::refused,
          fmt::format("Axis {} is not a servo axis: the board does not switch its motor.", name(i)),
          "Nothing was sent.");
    }
    auto switched = co_await switch_loop(i, request.on, request.closing);
    if (!switched) co_return switched;
  }
  co_return Result<>();
}

Task<Result<>> ServoDrive::may_drive(const Parameter& parameter, std::int64_t value, intent::Closing answer) {
  const int axis = parameter.axis;
  if (!parameter.fact->drives || loops_.closed(axis) == false) co_return Result<>();
  const auto before = values_.known(axis, parameter.fact->letters);
  const bool harder = before ? value > *before : value != 0;
  const bool at_work = values_.drives(axis) && snapshot_.axes[axis].loop == Loop::following;
  if (!harder || at_work) co_return Result<>();
  const std::string set =
      fmt::format("{} = {}", parameter.mnemonic, encode_number(value, parameter.fact->decimals));
  std::string state = fmt::format("The gains KP and KI of {} are 0", name(axis));
  std::string consequence = fmt::format("{} drives the motor there at once.", set);
  if (values_.drives(axis)) {
    state = fmt::format("{} does not reach its target", name(axis));
    consequence = fmt::format("{} drives it harder: as soon as it is free, it goes there at once.", set);
  }
  co_return co_await may_close(axis, answer, std::move(state), std::move(consequence));
}

// With the loop open, LP loads both counters with the same number on any reading of the data sheet: that of
// the encoder, which stays true. HN is in the same text, so the motor is free only while the board reads it.
Task<Result<>> ServoDrive::take_place(int axis) {
  if (motions_.moving(axis))
    co_return fail(FaultKind::refused, fmt::format("Axis {} is still moving.", name(axis)),
                   "Nothing was sent.", "Wait until the motion ends, or stop it.");
  const bool closed = loops_.closed(axis) != false;
  const std::int64_t here = snapshot_.axes[axis].encoder.value;
  std::string text =
      selection_.addressed(axis, closed ? fmt::format("HF LP{} HN", here) : fmt::format("LP{}", here));
  motions_.counts(axis);
  if (motions_.ours(axis)) motions_.end(axis, EndedBy::stop);  // its target has been given up
  auto sent = co_await commands_.transmit(std::move(text), Priority::intent);
  if (!sent) next_.asks_loops();
  if (!sent) co_return sent;
  auto read = co_await readings_.read_axes(Priority::intent);
  if (!read) co_return read;
  motions_.begins_to_settle(axis);
  if (!snapshot_.axes[axis].far_off) co_return Result<>();
  co_return fail(
      FaultKind::controller,
      fmt::format("The position of {} was to become its command, but its command is still {} counts away.",
                  name(axis), std::abs(snapshot_.axes[axis].following_error().value)),
      "Nothing else was sent.", "Check whether the axis moves.");
}

}  // namespace hw::vme58
