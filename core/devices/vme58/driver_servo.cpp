// Servo axes: where they stand is where their encoder stands, so a motion has ended when that has come to
// where the command has. And what closes a loop, or makes it drive harder, is asked about while it stands far
// off.
//
// A stop and a jog have no place to come to: an axis that the console, or a text, stops rests when its
// command rests, and shows its following error. Relative moves add to the command, not to the encoder, or
// each would carry on the error of the one before.
#include <algorithm>
#include <cstdlib>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

/// Errors up to this are what loops at work have: a few degrees of the usual encoders. A motor that is driven
/// over more moves its stage visibly, and at full output. A greater deadband says that more is usual here.
constexpr std::int64_t large_error = 100;

}  // namespace

// ---- places

std::optional<std::int64_t> Vme58Driver::known_param(int axis, std::string_view letters) const {
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    if (parameters_[i].axis == axis && parameters_[i].fact->letters == letters && draft_.params[i].known)
      return draft_.params[i].value;
  return std::nullopt;
}

/// HD shows nowhere: it is known while the console has set it.
std::int64_t Vme58Driver::deadband(int axis) const {
  const auto set = known_param(axis, "HD");
  return set && *set > 0 ? *set : usual_deadband;
}

/// Some gain answers a standing error, as far as is known.
bool Vme58Driver::driven(int axis) const {
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    if (parameters_[i].axis == axis && parameters_[i].fact->drives &&
        (!draft_.params[i].known || draft_.params[i].value != 0))
      return true;
  return false;
}

void Vme58Driver::know_loop(int axis, std::optional<bool> closed) {
  if (!catalog_.axes[ix(axis)].servo) return;
  minds_[ix(axis)].servo.closed = closed;
  AxisState& state = draft_.axes[axis];
  state.enabled = closed.value_or(true);
  const Loop place = minds_[ix(axis)].servo.place.place();
  state.loop = !closed ? Loop::unknown : *closed ? place : Loop::open;
}

void Vme58Driver::show_place(int i, Instant at, bool turns) {
  if (!catalog_.axes[ix(i)].servo) return;
  ServoMind& servo = minds_[ix(i)].servo;
  AxisState& axis = draft_.axes[i];
  const std::int64_t off = std::abs((axis.command - axis.encoder).value), band = deadband(i);
  servo.place.look(at, turns, off, band);
  if (turns) servo.settling = servo.goes_to_place;
  axis.far_off = off > std::max(large_error, band);
  know_loop(i, servo.closed);
  if (axis.loop == Loop::in_place && axis.ended_by == EndedBy::not_in_place)
    axis.ended_by = EndedBy::target;  // it came late
}

/// Its command has ended, and its encoder has yet to show whether it came there.
bool Vme58Driver::settles(int i) const {
  const ServoMind& servo = minds_[ix(i)].servo;
  return servo.settling && servo.place.undecided() && servo.closed != false;
}

/// What seems to have come to its target has not while its encoder stands elsewhere. Told once.
EndedBy Vme58Driver::judged(int i, EndedBy ended_by) {
  ServoMind& servo = minds_[ix(i)].servo;
  const bool came = std::exchange(servo.settling, false) && ended_by == EndedBy::target;
  if (!came || servo.closed == false || servo.place.place() != Loop::off_place) return ended_by;
  loops_wanted_ = true;
  const AxisState& axis = draft_.axes[i];
  tell(
      Notice::Kind::warning,
      fmt::format("{0} has not come where it was sent: 2 s after its command has ended its encoder stands at "
                  "{1}, {2} counts from there. {3}",
                  axis_name(i), axis.encoder.value, std::abs((axis.command - axis.encoder).value),
                  driven(i) ? "Look what holds it, and at its gains."
                            : "Nothing drives it: its gains KP and KI read 0."));
  return EndedBy::not_in_place;
}

/// It is driven to its command, or that is brought to it: what was told of how it ended is over.
void Vme58Driver::begins_to_settle(int i) {
  if (moving(i)) return;
  ServoMind& servo = minds_[ix(i)].servo;
  servo.place.begin(now());
  servo.settling = true;
  draft_.axes[i].ended_by = EndedBy::nothing;
  know_loop(i, servo.closed);
  show_still(i, now());
}

// LP loads both counters (decision M92). Whether with the same number, or so that a closed loop keeps its
// error, shows in what is read then. It is the encoder that has to read `wanted`.
Task<Result<>> Vme58Driver::load_positions(int axis, Steps wanted) {
  for (int attempt = 0; attempt < 2; ++attempt) {
    auto read = co_await readings_.read_axes(Priority::intent);
    if (!read) co_return read;
    std::array<std::optional<std::int64_t>, most_axes> loaded{};
    for (int i = 0; i < axis_count(); ++i) {
      if (axis >= 0 && axis != i) continue;
      const bool keeps_error = catalog_.axes[ix(i)].servo && minds_[ix(i)].servo.closed != false;
      loaded[ix(i)] = wanted.value + (keeps_error ? draft_.axes[i].following_error().value : 0);
      minds_[ix(i)].counted = true;
    }
    std::string text = axis >= 0 ? addressed(axis, fmt::format("LP{}", *loaded[ix(axis)]))
                                 : selection_.addressed("AA", encode_list("LP", loaded));
    auto sent = co_await commands_.say(std::move(text), Priority::intent);
    if (!sent) co_return sent;
    read = co_await readings_.read_axes(Priority::intent);
    if (!read) co_return read;
    bool alike = false;
    for (int i = 0; i < axis_count(); ++i)
      alike = alike || (loaded[ix(i)] && *loaded[ix(i)] != wanted.value && !moving(i) &&
                        draft_.axes[i].encoder.value == *loaded[ix(i)]);
    if (!alike) break;
  }
  co_return Result<>();
}

// ---- what closes a loop

Task<Result<>> Vme58Driver::may_close(int axis, intent::Closing answer, std::string state,
                                      std::string consequence) {
  auto read = co_await readings_.read_axes(Priority::intent);
  if (!read) co_return read;
  if (!draft_.axes[axis].far_off || answer == intent::Closing::drive) co_return Result<>();
  if (answer == intent::Closing::stay) co_return co_await take_place(axis);
  co_return fail(FaultKind::asks,
                 fmt::format("{}, and its encoder stands {} counts from its command. {}", state,
                             std::abs(draft_.axes[axis].following_error().value), consequence),
                 "Nothing was sent.",
                 "Take the place where it stands as its command first, or let it be driven there.");
}

/// Of an open loop, or one that the board has not told of. What a board does with the error when HN closes it
/// the data sheet does not say.
Task<Result<>> Vme58Driver::switch_loop(int axis, bool on, intent::Closing answer) {
  const bool was_far = draft_.axes[axis].far_off;
  if (on && minds_[ix(axis)].servo.closed != true) {
    std::string state = fmt::format("The loop of {} is open", axis_name(axis));
    std::string consequence = "Closing it may drive the motor there at once.";
    auto may = co_await may_close(axis, answer, std::move(state), std::move(consequence));
    if (!may) co_return may;
  }
  std::string text = addressed(axis, on ? "HN" : "HF");
  minds_[ix(axis)].counted = true;  // the board may take the place of the shaft as its command
  auto sent = co_await commands_.say(std::move(text), Priority::intent);
  if (!sent) loops_wanted_ = true;
  if (!sent) co_return sent;
  know_loop(axis, on);
  if (on && was_far) begins_to_settle(axis);
  co_return sent;
}

/// A gain that makes a closed loop act on its error. One that follows its command, or settles, may be tuned.
Task<Result<>> Vme58Driver::may_drive(const Parameter& parameter, std::int64_t value,
                                      intent::Closing answer) {
  const int axis = parameter.axis;
  if (!parameter.fact->drives || minds_[ix(axis)].servo.closed == false) co_return Result<>();
  const auto before = known_param(axis, parameter.fact->letters);
  const bool harder = before ? value > *before : value != 0;
  const bool at_work = driven(axis) && draft_.axes[axis].loop == Loop::following;
  if (!harder || at_work) co_return Result<>();
  const std::string set =
      fmt::format("{} = {}", parameter.mnemonic, encode_number(value, parameter.fact->decimals));
  std::string state = fmt::format("The gains KP and KI of {} are 0", axis_name(axis));
  std::string consequence = fmt::format("{} drives the motor there at once.", set);
  if (driven(axis)) {
    state = fmt::format("{} does not come where it was sent", axis_name(axis));
    consequence = fmt::format("{} drives it harder: when it comes free it goes there at once.", set);
  }
  co_return co_await may_close(axis, answer, std::move(state), std::move(consequence));
}

// With the loop open LP loads both counters with the same number on any reading of the data sheet: that of
// the encoder, which stays true. HN stands in the same text, so the motor is free for no longer than the
// board takes to read it.
Task<Result<>> Vme58Driver::take_place(int axis) {
  if (moving(axis))
    co_return fail(FaultKind::refused, fmt::format("Axis {} is still moving.", axis_name(axis)),
                   "Nothing was sent.", "Wait until it ends, or stop it.");
  const bool closed = minds_[ix(axis)].servo.closed != false;
  const std::int64_t here = draft_.axes[axis].encoder.value;
  std::string text = addressed(axis, closed ? fmt::format("HF LP{} HN", here) : fmt::format("LP{}", here));
  minds_[ix(axis)].counted = true;
  if (minds_[ix(axis)].ours) end_motion(axis, EndedBy::stop);  // what it was sent to is not wanted any more
  auto sent = co_await commands_.say(std::move(text), Priority::intent);
  if (!sent) loops_wanted_ = true;
  if (!sent) co_return sent;
  auto read = co_await readings_.read_axes(Priority::intent);
  if (!read) co_return read;
  begins_to_settle(axis);
  if (!draft_.axes[axis].far_off) co_return Result<>();
  co_return fail(FaultKind::controller,
                 fmt::format("The place of {} was to become its command, which stands {} counts from there.",
                             axis_name(axis), std::abs(draft_.axes[axis].following_error().value)),
                 "Nothing else was sent.", "Look whether it moves.");
}

/// Raw text goes as it is typed; it is said what it did. True: it may drive its axis there.
bool Vme58Driver::warn_of_closing(const TextCommand& command) {
  const int axis = command.context.axis;
  if (command.context.mode != where::single || !draft_.axes[axis].far_off) return false;
  const auto& closed = minds_[ix(axis)].servo.closed;
  const bool gain = command.is(Op::KP) || command.is(Op::KI);
  const bool above_zero = !command.numbers.empty() && command.numbers.front().value_or(0) > 0;
  const bool drives = gain && above_zero && closed != false && !driven(axis);
  if (!drives && !(command.is(Op::HN) && closed != true)) return false;
  tell(Notice::Kind::warning,
       fmt::format("{} was sent while the encoder of {} stood {} counts from its command: the motor may be "
                   "driven there at once.",
                   command.text, axis_name(axis), std::abs(draft_.axes[axis].following_error().value)));
  return true;
}

}  // namespace hw::vme58
