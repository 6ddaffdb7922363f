// At which speed an axis goes: VL, which is the user's, and which a move with a speed of its own borrows.
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

constexpr Duration rest_time = Millis(400);  // at rest so long without a done flag: it may have ended

}  // namespace

std::int64_t Vme58Driver::velocity_of(int axis) const { return value(axis, AxisValue::maximum_velocity); }

std::int64_t Vme58Driver::own_velocity_of(int axis) const {
  const AxisMind& mind = minds_[ix(axis)];
  if (mind.velocity) return mind.velocity->before;
  return mind.put_velocity ? mind.put_velocity->value : velocity_of(axis);
}

/// In turn it would be read once in a second or two, and a text may just have set it. One that may wait in a
/// queue is believed until the queues are empty.
Task<Result<>> Vme58Driver::read_velocity(int axis, Priority priority) {
  Result<> read;
  if (minds_[ix(axis)].put_velocity) read = co_await read_queues(Priority::poll);
  readings_.next_is(axis);
  if (read) read = co_await readings_.read_axes(priority);
  if (read) co_return read;
  FaultKind& kind = read.error().kind;
  if (kind == FaultKind::no_answer || kind == FaultKind::garbled) {
    kind = FaultKind::refused;
    read.error().done = "Nothing was sent.";
  }
  co_return read;
}

Task<Result<>> Vme58Driver::borrow_velocity(int axis, std::int64_t speed) {
  if (!minds_[ix(axis)].velocity) {
    auto read = co_await read_velocity(axis, Priority::intent);
    if (!read) co_return read;
  }
  minds_[ix(axis)].velocity = Borrowed{own_velocity_of(axis), speed};
  co_return Result<>();
}

Task<Result<>> Vme58Driver::give_speed_back(int axis, Priority priority) {
  if (!minds_[ix(axis)].velocity || selection_.recording()) co_return Result<>();
  const Borrowed borrowed = *minds_[ix(axis)].velocity;
  if (borrowed.left_alone) {
    auto read = co_await read_velocity(axis, priority);
    if (!read) co_return read;
  }
  const bool anothers = borrowed.left_alone && velocity_of(axis) != borrowed.for_now;
  if (borrowed.before == borrowed.for_now || anothers) {
    minds_[ix(axis)].velocity.reset();
    co_return Result<>();
  }
  std::string text = addressed(axis, fmt::format("VL{}", borrowed.before));
  auto given = co_await commands_.say(std::move(text), priority);
  if (!given && given.error().kind != FaultKind::controller) co_return given;  // it is still to be done
  minds_[ix(axis)].velocity.reset();
  if (draft_.working) minds_[ix(axis)].put_velocity = PutVelocity{borrowed.before};
  // It is shown as the axis' own before it comes to be read in turn.
  readings_.know(axis, AxisValue::maximum_velocity, borrowed.before);
  readings_.next_is(axis);
  co_return given;
}

Task<Result<>> Vme58Driver::give_speeds_back(Priority priority) {
  for (int i = 0; i < axis_count(); ++i) {
    if (minds_[ix(i)].ours) continue;
    auto given = co_await give_speed_back(i, priority);
    if (!given) co_return given;
  }
  co_return Result<>();
}

/// What comes behind a motion that is under way, in the same queue, goes at the axis' own speed. At its end
/// that is given back once more: a stop may take this out of the queue. A move of several axes stands in the
/// queue of AM, and what is put into theirs may come before it.
Task<Result<>> Vme58Driver::give_speeds_behind_motions(Priority priority) {
  for (int i = 0; i < axis_count() && !selection_.recording(); ++i) {
    const auto& borrowed = minds_[ix(i)].velocity;
    if (!borrowed || borrowed->waits_behind || !minds_[ix(i)].ours || minds_[ix(i)].group != 0) continue;
    std::string text = addressed(i, fmt::format("VL{}", borrowed->before));
    auto given = co_await commands_.say(std::move(text), priority);
    if (!given) co_return given;
    if (minds_[ix(i)].velocity) minds_[ix(i)].velocity->waits_behind = true;
  }
  co_return Result<>();
}

/// What is set while it is borrowed is what is given back.
void Vme58Driver::note_velocity(const TextCommand& command) {
  const bool one = command.context.mode == where::single;
  for (int i = 0; i < axis_count(); ++i) {
    const std::size_t place = one ? 0 : ix(i);
    if ((one && i != command.context.axis) || place >= command.numbers.size() || !command.numbers[place])
      continue;
    const double unit = selection_.user_unit(i) != 0 ? selection_.user_unit(i) : 1;
    AxisMind& mind = minds_[ix(i)];
    mind.put_velocity = PutVelocity{std::llround(*command.numbers[place] * unit)};
    if (mind.velocity) mind.velocity->before = mind.put_velocity->value;
  }
}

/// Its queue is emptied: what waits there is never carried out, nor is what was to be put back behind it.
/// -1: all.
void Vme58Driver::forget_put_velocities(int axis) {
  for (int i = 0; i < axis_count(); ++i) {
    AxisMind& mind = minds_[ix(i)];
    if (axis >= 0 && i != axis) continue;
    if (mind.velocity && mind.put_velocity) mind.velocity->left_alone = true;
    mind.put_velocity.reset();
  }
}

// ---- for how long a motion may show nothing

/// For so long an axis that turns may show neither velocity nor count: an axis that is ramped very gently,
/// which a queue tells of only when it moves by itself.
Duration Vme58Driver::rest_patience(int i) const {
  const AxisMind& mind = minds_[ix(i)];
  if (mind.group == 0 && mind.wanted != Activity::jogging) return rest_time;
  return std::max(jog_gap(i, 1), mind.jog_gap);
}

/// A jog's: until its first count, and between two counts when it is slower than one a second.
Duration Vme58Driver::jog_gap(int i, double speed) const {
  const auto acceleration = static_cast<double>(std::max<std::int64_t>(1, value(i, AxisValue::acceleration)));
  const double ramp_s = 2 * std::sqrt(2 / acceleration);
  const double count_s = speed > 0 && speed < 1 ? 1.5 / speed : 0;
  return rest_time + from_seconds(ramp_s + count_s);
}

void Vme58Driver::begins_to_creep(int i, Duration gap) {
  AxisMind& mind = minds_[ix(i)];
  mind.jog_gap = gap;
  mind.creeps_until = gap > Duration::zero() ? now() + gap : Instant{};
}

}  // namespace hw::vme58
