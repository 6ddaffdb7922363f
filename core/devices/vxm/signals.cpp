#include "core/devices/vxm/signals.h"

#include <algorithm>

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/reply_kinds.h"

namespace hw::vxm {
namespace {

constexpr int readings = 4;  // readings at most: one unexpected, one after it, and two that agree
constexpr Duration limits_hold = std::chrono::seconds(3);
constexpr int questions_between = 20;  // questions between two readings, each as late as the line

}  // namespace

void Signals::begin() {
  asked_ = once_ = {};
  cleaned_ = {};
}

// Signals share one age, that of the latest reading.
void Signals::forget_doubtful() {
  if (cleaned_[all.find('~')] != conversation_.times_cleaned()) snapshot_.inputs_known = 0;
  if (cleaned_[all.find('$')] != conversation_.times_cleaned()) snapshot_.outputs_known = 0;
  const Station* station = conversation_.station();
  const Duration late = station ? questions_between * station->lateness() : Duration{};
  const bool old = scheduler_.now() - limits_at_ > limits_hold + late;
  const bool dirty = station && station->is_dirty();
  if (!dirty && !old && cleaned_[0] == conversation_.times_cleaned()) return;
  for (int axis = 0; axis < snapshot_.axis_count; ++axis) snapshot_.axes[axis].limits_known = false;
}

// @ follows them: its reply is a line.
Task<Result<>> Signals::read_all(Priority priority) {
  for (int n = 0; n < readings; ++n) {
    for (const char which : all) {
      auto asked = co_await ask(which, priority);
      if (!asked) co_return asked;
    }
    auto analog = co_await read_analog(priority);
    if (!analog) co_return analog;
    if (confirm()) break;
  }
  co_return Result<>();
}

Task<Result<>> Signals::read(std::string_view which, Priority priority) {
  for (int n = 0; n < readings; ++n) {
    for (const char one : which) {
      auto asked = co_await ask(one, priority);
      if (!asked) co_return asked;
    }
    auto state = co_await conversation_.state(priority);
    if (!state) co_return fail(state.error());
    if (confirm() || !is_reported(which.front())) break;
  }
  co_return Result<>();
}

Task<Result<>> Signals::glance(Priority priority) {
  const Instant now = scheduler_.now();
  const bool inputs = now < inputs_until_, limits = now < limits_until_;
  if ((!inputs && !limits) || priority != Priority::poll || conversation_.echoes()) co_return Result<>();
  auto seen = co_await read(!limits ? "~" : inputs ? "?~" : "?", priority);
  if (seen) changed_();
  co_return seen;
}

Task<Result<>> Signals::ask_next(Priority priority) {
  asked_at_ = scheduler_.now();
  const auto turn = static_cast<std::size_t>(turn_.next(static_cast<int>(all.size()) + 1));
  if (turn == all.size()) co_return co_await read_analog(priority);
  co_return co_await ask(all[turn], priority);
}

Task<Result<>> Signals::ask(char which, Priority priority) {
  if (!is_reported(which)) co_return Result<>();
  if (std::none_of(asked_.begin(), asked_.end(), [](const auto& byte) { return byte.has_value(); }))
    unexpected_ = conversation_.unexpected();
  auto byte = co_await conversation_.raw(which, priority);
  if (!byte) {
    asked_ = {};
    if (which == '$') identification_.doubt_outputs();
    co_return fail(byte.error());
  }
  if (which == '~') inputs_asked_at_ = conversation_.asked_at();
  asked_[all.find(which)] = *byte;
  co_return Result<>();
}

Task<Result<>> Signals::read_analog(Priority priority) {
  auto number = co_await conversation_.number("@", priority);
  if (!number) {
    asked_ = {};
    co_return fail(number.error());
  }
  snapshot_.analog[0] = static_cast<std::int32_t>(*number);
  snapshot_.analog_known |= 1;
  snapshot_.analog_seen_at[0] = scheduler_.now();
  co_return Result<>();
}

bool Signals::confirm() {
  const auto asked = std::exchange(asked_, {});
  bool all_believed = true, any = false;
  for (const auto& byte : asked) any = any || byte.has_value();
  if (any && conversation_.unexpected() != unexpected_) {  // unknown which byte answered which question
    if (Station* station = conversation_.station()) station->doubt(reply_kind::raw);
    return false;
  }
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (asked[i]) all_believed = believe(i, *asked[i]) && all_believed;
  return all_believed;
}

bool Signals::believe(std::size_t i, unsigned char byte) {
  const bool second = std::exchange(once_[i], byte) == byte;
  if (cleaned_[i] != conversation_.times_cleaned() && !second) return false;
  cleaned_[i] = conversation_.times_cleaned();
  show(i, byte);
  return true;
}

void Signals::show(std::size_t i, unsigned char byte) {
  switch (all[i]) {
    case '~':
      snapshot_.inputs = inputs_of(byte);
      snapshot_.inputs_known = 0xFF;
      snapshot_.inputs_asked_at = inputs_asked_at_;
      break;
    case '$':
      snapshot_.outputs = byte & 0x0Fu;
      snapshot_.outputs_known = 0x0F;
      snapshot_.io_seen_at = scheduler_.now();
      break;
    default:
      limits_at_ = scheduler_.now();
      for (int axis = 0; axis < snapshot_.axis_count; ++axis) {
        snapshot_.axes[axis].limit_minus = limit_active(byte, axis, Sign::minus);
        snapshot_.axes[axis].limit_plus = limit_active(byte, axis, Sign::plus);
        snapshot_.axes[axis].limits_known = axis < motors_per_controller || identification_.has_slave();
      }
  }
}

}  // namespace hw::vxm
