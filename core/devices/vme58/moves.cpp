#include "core/devices/vme58/moves.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/axis_check.h"
#include "core/device/homing.h"

namespace hw::vme58 {

void forget_rejection(Snapshot& snapshot) {
  if (snapshot.program.run != RunState::error) return;
  snapshot.program.run = RunState::idle;
  snapshot.notice.clear();
}

// ---- checks

Result<> Moves::may_move(int axis) const {
  if (auto may = commands_.may_talk(); !may) return may;
  if (auto has = check_axis(catalog_, axis); !has) return has;
  if (snapshot_.program.run == RunState::running)
    return fail(FaultKind::refused, "A program is running.", "Nothing was sent.",
                "Wait until it ends, or stop it.");
  // An axis that only settles may be sent on, so that repeated single steps need not wait for each other.
  if (motions_.ours(axis) && !motions_.jogs(axis) && !loops_.only_settles(axis))
    return fail(FaultKind::refused, fmt::format("Axis {} is still moving.", name(axis)), "Nothing was sent.",
                "Wait until it ends, or stop it.");
  return {};
}

Result<Moves::Request> Moves::checked(const std::vector<AxisTarget>& targets, bool relative) const {
  for (const AxisTarget& t : targets)
    if (auto may = may_move(t.axis.index); !may) return fail(may.error());
  const auto goals = check_move(catalog_, snapshot_, targets, relative ? MoveBase::position : MoveBase::zero);
  if (!goals) return fail(goals.error());
  Request request;
  request.way.has_targets = true;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const AxisTarget& t = targets[i];
    if (relative && t.value.value == 0) continue;
    const int axis = t.axis.index;
    request.operands[ix(axis)] = t.value.value;
    request.way.targets[ix(axis)] = (*goals)[i];
    request.way.axes |= 1u << axis;
  }
  return request;
}

// ---- moves

/// Sends the text that starts a motion, and shows the motion as begun until the board reports more.
Task<Result<>> Moves::begin(std::string text, Motions::Way way) {
  forget_rejection(snapshot_);
  snapshot_.program.ended_by = EndedBy::nothing;  // from here on the end of the new motion is reported
  const Motions::Before before = motions_.begin(way);
  auto sent = co_await commands_.transmit(std::move(text), Priority::intent);
  if (!sent) motions_.did_not_begin(way, before, wire_.perhaps_done(sent.error()));
  co_return sent;
}

Task<Result<>> Moves::move(std::vector<AxisTarget> targets, intent::Pace requested_pace, bool relative,
                           Activity shown_as) {
  const auto pace = checked(requested_pace);
  if (!pace) co_return fail(pace.error());
  auto request = checked(targets, relative);
  if (!request) co_return fail(request.error());
  request->way.activity = shown_as;
  for (int i = 0; i < axes(); ++i) {
    if ((request->way.axes >> i & 1) == 0) continue;
    auto set = co_await speeds_.borrow(i, *pace);
    if (!set) co_return set;
  }
  if (request->way.axes == 0) co_return Result<>();
  std::string text = move_text(*request, *pace, relative);
  co_return co_await begin(std::move(text), request->way);
}

namespace {

/// VL and AC wait in the queue like the motion, so the code that sees the motion end can restore them behind
/// it.
std::string pace_text(WholePace pace) {
  std::string text;
  if (pace.speed > 0) text += fmt::format("VL{} ", pace.speed);
  if (pace.acceleration > 0) text += fmt::format("AC{} ", pace.acceleration);
  return text;
}

}  // namespace

std::string Moves::move_text(const Request& request, WholePace pace, bool relative) const {
  const std::string_view letters = relative ? "MR" : "MA";
  const unsigned moved = request.way.axes;
  int only = 0;
  while ((moved >> only & 1) == 0) ++only;
  if ((moved & (moved - 1)) == 0)
    return selection_.addressed(
        only, fmt::format("{}{}{} GD ID", pace_text(pace), letters, *request.operands[ix(only)]));
  const auto of_all = [&](std::string_view setting, std::int64_t value) {
    Operands values{};
    for (int i = 0; i < axes(); ++i)
      if ((moved >> i & 1) != 0) values[ix(i)] = value;
    return value > 0 ? encode_list(setting, values) + " " : std::string();
  };
  const std::string first = of_all("VL", pace.speed) + of_all("AC", pace.acceleration);
  return selection_.addressed("AM", first + encode_list(letters, request.operands) + " GD ID");
}

Task<Result<>> Moves::jog(intent::JogStart request) {
  if (request.up_to) {
    std::vector<AxisTarget> end(1, AxisTarget{request.axis, *request.up_to});
    co_return co_await move(std::move(end), pace_of(request), false, Activity::jogging);
  }
  const int axis = request.axis.index;
  if (auto may = may_move(axis); !may) co_return may;
  auto pace = checked(pace_of(request));
  if (!pace) co_return fail(pace.error());
  if (pace->speed == 0) {
    auto read = co_await speeds_.velocity.read(axis, Priority::intent);
    if (!read) co_return read;
    pace->speed = std::max<std::int64_t>(1, speeds_.velocity.own(axis));
  }
  if (pace->acceleration > 0) {
    auto set = co_await speeds_.acceleration.borrow(axis, pace->acceleration);
    if (!set) co_return set;
  }
  motions_.will_jog(axis, static_cast<double>(pace->speed));
  const std::string ramp = pace_text({0, pace->acceleration});
  std::string text =
      selection_.addressed(axis, fmt::format("{}JG{}", ramp, factor(request.sign) * pace->speed));
  co_return co_await begin_jog(std::move(text), axis);
}

Task<Result<>> Moves::jog_slowly(int axis, std::int64_t thousandths) {
  if (auto may = may_move(axis); !may) co_return may;
  std::string text = selection_.addressed(axis, "JF" + encode_number(thousandths, 3));
  if (thousandths == 0) co_return co_await commands_.transmit(std::move(text), Priority::intent);
  motions_.will_jog(axis, std::abs(static_cast<double>(thousandths)) / 1000);
  co_return co_await begin_jog(std::move(text), axis);
}

// A user who reads that the jog has not begun will not stop it. But the command error may belong to another
// command and may have been seen while the jog waited in the ring. So this axis alone is stopped, which has
// no effect at rest.
Task<Result<>> Moves::begin_jog(std::string text, int axis) {
  Motions::Way way;
  way.axes = 1u << axis;
  way.activity = Activity::jogging;
  auto begun = co_await begin(std::move(text), way);
  if (begun) co_return begun;
  FaultKind& kind = begun.error().kind;
  if (kind == FaultKind::no_answer) {
    // The text was taken back, unless the board was just reading it.
    const auto read = co_await readings_.read_axes(Priority::intent);
    if (read && !motions_.moving(axis)) kind = FaultKind::refused;
  } else if (kind == FaultKind::controller) {
    speeds_.forget_put(axis);
    motions_.stopping(axis, false);  // this also stops an earlier jog
    std::string stop = selection_.addressed(axis, "ST");
    const auto stopped = co_await conversation_.write(std::move(stop), Priority::intent);
    if (!stopped) kind = stopped.error().kind == FaultKind::lost ? FaultKind::lost : FaultKind::no_answer;
  }
  co_return begun;
}

// CA first: clears the done flag of an earlier motion.
Task<Result<>> Moves::home(intent::Home request) {
  const int axis = request.axis.index;
  if (auto may = may_move(axis); !may) co_return may;
  if (auto may = check_home(catalog_, request); !may) co_return may;
  const bool plus = request.sign == Sign::plus;
  std::string text;
  switch (static_cast<HomeMode>(request.mode)) {
    case HomeMode::edge: text = plus ? "HM0 ID" : "HR0 ID"; break;
    case HomeMode::back_to_edge: text = plus ? "HM0 MA0 GO ID" : "HR0 MA0 GO ID"; break;
    case HomeMode::stop_dead: text = plus ? "KM ID" : "KR ID"; break;
  }
  const auto pace = checked(request.pace);
  if (!pace) co_return fail(pace.error());
  auto set = co_await speeds_.borrow(axis, *pace);
  if (!set) co_return set;
  Motions::Way way;
  way.axes = 1u << axis;
  way.activity = Activity::homing;
  const bool dead = static_cast<HomeMode>(request.mode) == HomeMode::stop_dead;
  way.at_home = dead ? AtHome::stops_dead : AtHome::sets_counter;
  text = selection_.addressed(axis, "CA " + pace_text(*pace) + text);
  co_return co_await begin(std::move(text), way);
}

}  // namespace hw::vme58
