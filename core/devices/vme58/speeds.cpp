#include "core/devices/vme58/speeds.h"

namespace hw::vme58 {

Task<Result<>> Speeds::borrow(int axis, WholePace pace) {
  Result<> set;
  if (pace.speed > 0)
    set = co_await velocity.borrow(axis, pace.speed);
  else
    set = co_await velocity.give_back(axis, Priority::intent);
  if (!set) co_return set;
  if (pace.acceleration > 0)
    set = co_await acceleration.borrow(axis, pace.acceleration);
  else
    set = co_await acceleration.give_back(axis, Priority::intent);
  co_return set;
}

Task<Result<>> Speeds::give_back(int axis, Priority priority) {
  auto given = co_await velocity.give_back(axis, priority);
  if (given) given = co_await acceleration.give_back(axis, priority);
  co_return given;
}

Task<Result<>> Speeds::give_all_back(Priority priority) {
  auto given = co_await velocity.give_all_back(priority);
  if (given) given = co_await acceleration.give_all_back(priority);
  co_return given;
}

Task<Result<>> Speeds::give_back_behind_motions(Priority priority) {
  auto given = co_await velocity.give_back_behind_motions(priority);
  if (given) given = co_await acceleration.give_back_behind_motions(priority);
  co_return given;
}

void Speeds::note(const TextCommand& command) {
  if (command.fact->op == Op::VL) velocity.note(command);
  if (command.fact->op == Op::AC) acceleration.note(command);
}

OwnSetting* Speeds::shown_at(std::optional<AxisValue> cell) {
  if (cell == AxisValue::maximum_velocity) return &velocity;
  return cell == AxisValue::acceleration ? &acceleration : nullptr;
}

}  // namespace hw::vme58
