#include "core/devices/vme58/own_setting.h"

#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace hw::vme58 {

std::int64_t OwnSetting::shown(int axis) const { return readings_.value(axis, cell_); }

std::int64_t OwnSetting::own(int axis) const {
  if (at(axis).borrowed) return at(axis).borrowed->before;
  return at(axis).put ? at(axis).put->value : shown(axis);
}

Task<Result<>> OwnSetting::read(int axis, Priority priority) {
  Result<> read;
  if (at(axis).put) read = co_await queues_.read(Priority::poll);
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

Task<Result<>> OwnSetting::borrow(int axis, std::int64_t value) {
  if (!at(axis).borrowed) {
    auto found = co_await read(axis, Priority::intent);
    if (!found) co_return found;
  }
  at(axis).borrowed = Borrowed{own(axis), value};
  co_return Result<>();
}

Task<Result<>> OwnSetting::give_back(int axis, Priority priority) {
  if (!at(axis).borrowed || selection_.recording()) co_return Result<>();
  const Borrowed borrowed = *at(axis).borrowed;
  if (borrowed.left_alone) {
    auto found = co_await read(axis, priority);
    if (!found) co_return found;
  }
  const bool anothers = borrowed.left_alone && shown(axis) != borrowed.for_now;
  if (borrowed.before == borrowed.for_now || anothers) {
    at(axis).borrowed.reset();
    co_return Result<>();
  }
  std::string text = selection_.addressed(axis, fmt::format("{}{}", letters_, borrowed.before));
  auto given = co_await commands_.transmit(std::move(text), priority);
  if (!given && given.error().kind != FaultKind::controller) co_return given;  // the next round tries again
  at(axis).borrowed.reset();
  if (snapshot_.working) at(axis).put = Put{borrowed.before};
  // Shows the value as the axis' own before its turn to be read.
  readings_.know(axis, cell_, borrowed.before);
  readings_.next_is(axis);
  co_return given;
}

Task<Result<>> OwnSetting::give_all_back(Priority priority) {
  for (int i = 0; i < count(); ++i) {
    if (motions_.ours(i)) continue;
    auto given = co_await give_back(i, priority);
    if (!given) co_return given;
  }
  co_return Result<>();
}

Task<Result<>> OwnSetting::give_back_behind_motions(Priority priority) {
  for (int i = 0; i < count() && !selection_.recording(); ++i) {
    const auto& borrowed = at(i).borrowed;
    if (!borrowed || borrowed->waits_behind || !motions_.ours(i) || motions_.moves_in_group(i)) continue;
    std::string text = selection_.addressed(i, fmt::format("{}{}", letters_, borrowed->before));
    auto given = co_await commands_.transmit(std::move(text), priority);
    if (!given) co_return given;
    if (at(i).borrowed) at(i).borrowed->waits_behind = true;
  }
  co_return Result<>();
}

void OwnSetting::note(const TextCommand& command) {
  const bool one = command.context.mode == where::single;
  for (int i = 0; i < count(); ++i) {
    const std::size_t place = one ? 0 : static_cast<std::size_t>(i);
    if ((one && i != command.context.axis) || place >= command.numbers.size() || !command.numbers[place])
      continue;
    const double unit = selection_.user_unit(i) != 0 ? selection_.user_unit(i) : 1;
    at(i).put = Put{std::llround(*command.numbers[place] * unit)};
    if (at(i).borrowed) at(i).borrowed->before = at(i).put->value;
  }
}

void OwnSetting::was_set(int axis, std::int64_t value) {
  if (at(axis).borrowed) at(axis).borrowed->before = value;
}

void OwnSetting::was_put(int axis, std::int64_t value, bool waits) {
  if (at(axis).put || waits) at(axis).put = Put{value};
}

void OwnSetting::forget_put(int axis) {
  for (int i = 0; i < count(); ++i) {
    if (axis >= 0 && i != axis) continue;
    if (at(i).borrowed && at(i).put) at(i).borrowed->left_alone = true;
    at(i).put.reset();
  }
}

bool OwnSetting::may_wait(int axis) const { return at(axis).put && !at(axis).put->carried_out; }

void OwnSetting::take_queues(unsigned all_free) {
  for (int i = 0; i < count(); ++i) {
    const unsigned its = 3u << count() | 1u << i;
    if (at(i).put && (all_free & its) == its) at(i).put->carried_out = true;
  }
}

void OwnSetting::take(int axis) {
  if (at(axis).put && at(axis).put->carried_out) at(axis).put.reset();
}

void OwnSetting::wire_lost() {
  for (Axis& axis : axes_) {
    axis.put.reset();
    if (axis.borrowed) axis.borrowed->left_alone = true;
  }
}

}  // namespace hw::vme58
