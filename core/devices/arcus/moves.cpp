#include "core/devices/arcus/moves.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/homing.h"
#include "core/device/target_check.h"
#include "core/devices/arcus/catalog_params.h"

namespace hw::arcus {

Task<Result<>> Moves::start(std::string text, std::vector<int> axes, Activity activity) {
  const std::string sent = text;
  auto done = co_await conversation_.command(std::move(text), Priority::intent);
  if (!done) {
    Fault fault = co_await status_.after_doubt(std::move(done.error()), sent);
    co_return fail(std::move(fault));
  }
  motions_.begun_together(axes, activity);
  co_return Result<>();
}

Task<Result<bool>> Moves::ask_incremental() {
  if (!console_.forms.mode.empty()) {
    auto mode = co_await conversation_.ask_number(std::string(console_.forms.mode), Priority::intent);
    if (!mode) co_return fail(mode.error());
    readouts_.put("MM", *mode);
  } else {
    auto read = co_await status_.read(Priority::intent);
    if (!read) co_return fail(read.error());
  }
  co_return readouts_.incremental();
}

// The position of the axis, or its target with StepNLoop. A digit lost on the wire would cause a wrong move.
Task<Result<std::int64_t>> Moves::ask_position(int axis) {
  std::string question = fill(console_.forms, console_.forms.position, axis);
  Conversation::Decode decode = decode_number;
  auto position = co_await conversation_.ask_confirmed(
      std::move(question), std::move(decode), console_.snapshot.axes[axis].position.value, Priority::intent);
  if (position || !console_.snapshot.axes[axis].position_known || position.error().kind != FaultKind::garbled)
    co_return position;
  co_return fail(
      FaultKind::garbled,
      fmt::format("Axis {} is moving, so it cannot be moved by a distance.", console_.axis_name(axis)),
      "Nothing was moved.", "Wait until it stops, or stop it.");
}

Task<Result<>> Moves::move(std::vector<AxisTarget> request, intent::Pace pace, bool relative,
                           Activity shown_as) {
  if (request.empty()) co_return Result<>();
  auto incremental = co_await ask_incremental();
  if (!incremental) co_return fail(incremental.error());
  std::vector<AxisValue> values;
  std::vector<int> axes;
  std::vector<Steps> goals;
  for (const AxisTarget& t : request) {
    const int axis = t.axis.index;
    if (auto may = console_.has_axis(axis); !may) co_return may;
    std::int64_t here = console_.snapshot.axes[axis].position.value;
    // Otherwise the number is sent as it is, and the move begins where the axis was seen at rest.
    if (relative != *incremental || console_.snapshot.axis_moves(axis)) {
      auto read = co_await ask_position(axis);
      if (!read) co_return fail(read.error());
      here = *read;
    }
    const auto target = check_target(console_.catalog, t.axis, Steps(relative ? here : 0), t.value);
    if (!target) co_return fail(target.error());
    values.push_back({axis, *incremental ? target->value - here : target->value});
    axes.push_back(axis);
    goals.push_back(*target);
  }
  auto borrowed = co_await borrow_pace(pace, axes.size() == 1 ? axes.front() : -1);
  if (!borrowed) co_return borrowed;
  auto started = co_await start(move_command(console_.forms, values), axes, shown_as);
  for (std::size_t i = 0; started && i < axes.size(); ++i) {
    motions_.goes_to(axes[i], goals[i], pace.speed);
    watch_.was_sent_to(axes[i], goals[i]);
  }
  co_await give_back_pace();
  co_return started;
}

Task<Result<>> Moves::jog(intent::JogStart request) {
  if (request.up_to) {
    std::vector<AxisTarget> end(1, AxisTarget{request.axis, *request.up_to});
    co_return co_await move(std::move(end), pace_of(request), false, Activity::jogging);
  }
  const int axis = request.axis.index;
  if (auto may = console_.has_axis(axis); !may) co_return may;
  auto borrowed = co_await borrow_pace(pace_of(request), axis);
  if (!borrowed) {
    Fault why = borrowed.error();
    if (why.kind == FaultKind::no_answer || why.kind == FaultKind::garbled) {
      why.kind = FaultKind::refused;  // no motion command was sent
      why.done = "The jog was not sent.";
    }
    co_return fail(std::move(why));
  }
  std::vector<int> axes{axis};
  auto started = co_await start(fill(console_.forms, console_.forms.jog, axis, request.sign), std::move(axes),
                                Activity::jogging);
  if (started) {
    console_.snapshot.axes[axis].direction = static_cast<std::int8_t>(factor(request.sign));
    console_.snapshot.axes[axis].has_target = false;
    watch_.jogs(axis, request.sign);
  }
  co_await give_back_pace();
  co_return started;
}

Task<Result<>> Moves::home(intent::Home request) {
  const int axis = request.axis.index;
  if (auto may = console_.has_axis(axis); !may) co_return may;
  if (auto may = check_home(console_.catalog, request); !may) co_return may;
  auto borrowed = co_await borrow_pace(request.pace, axis);
  if (!borrowed) co_return borrowed;
  watch_.counters_may_be_set();  // also if the reply is lost and the state is read afresh
  std::vector<int> axes{axis};
  auto started =
      co_await start(fill(console_.forms, console_.forms.homes[ix(request.mode)], axis, request.sign),
                     std::move(axes), Activity::homing);
  if (started) motions_.searches(axis, request.sign, request.pace.speed);
  co_await give_back_pace();
  if (!started) co_return started;
  watch_.counters_may_be_set();
  co_return Result<>();
}

// ---- the pace of one motion

Task<Result<bool>> Moves::has_own_speeds(int axis) {
  if (axis < 0 || !console_.forms.axis_speeds) co_return false;
  bool own = true;
  for (const std::string_view form :
       {console_.forms.axis_high_speed, console_.forms.axis_low_speed, console_.forms.axis_accel}) {
    auto value = co_await conversation_.ask_number(fill(console_.forms, form, axis), Priority::intent);
    if (!value) co_return fail(value.error());
    own = own && *value != 0;
  }
  co_return own;
}

Task<Result<>> Moves::borrow_pace(intent::Pace pace, int axis) {
  const auto whole = check_pace(console_.catalog, acceleration_unit(console_.model()), pace);
  if (!whole) co_return fail(whole.error());
  if (whole->speed == 0 && !pace.acceleration) co_return Result<>();
  const auto own = co_await has_own_speeds(axis);
  if (!own) co_return fail(own.error());
  const auto name_of = [&](std::string_view of_all, std::string_view of_axis) {
    return *own ? fill(console_.forms, of_axis, axis) : std::string(of_all);
  };
  if (whole->speed > 0) {
    std::string name = name_of(console_.forms.high_speed, console_.forms.axis_high_speed);
    const auto shown = setup_.param(name);
    auto borrowed = co_await borrowed_.borrow(std::move(name), whole->speed, shown);
    if (!borrowed) co_return borrowed;
  }
  if (!pace.acceleration) co_return Result<>();
  std::string name = name_of(console_.forms.accel, console_.forms.axis_accel);
  const auto shown = setup_.param(name);
  co_return co_await borrowed_.borrow(std::move(name), *pace.acceleration, shown);
}

Task<> Moves::give_back_pace() {
  auto returned = co_await borrowed_.give_back();
  if (!returned) console_.report(Notice::Kind::warning, returned.error().sentence());
}

// ---- counters

Task<Result<>> Moves::set_position(intent::SetPosition request) {
  const int first = request.axis < 0 ? 0 : request.axis,
            last = request.axis < 0 ? console_.axes() - 1 : request.axis;
  for (int axis = first; axis <= last; ++axis) {
    if (auto may = console_.has_axis(axis); !may) co_return may;
    auto set = co_await conversation_.command(
        set_command(fill(console_.forms, console_.forms.position, axis), request.value.value),
        Priority::intent);
    if (!set) {
      if (console_.snapshot.axes[axis].in_counts && set.error().kind == FaultKind::refused)
        set.error().advice = fmt::format(
            "Set the encoder counter instead: while StepNLoop of {} is on, its position follows the encoder.",
            console_.axis_name(axis));
      co_return set;
    }
    watch_.position_was_set(axis, request.value);
    console_.snapshot.axes[axis].trust.settle(Trust::set, console_.scheduler.now());
    console_.snapshot.axes[axis].has_target = false;  // the count has another origin now
  }
  co_return co_await status_.read(Priority::intent);
}

Task<Result<>> Moves::set_encoder(intent::SetEncoder request) {
  const int first = request.axis < 0 ? 0 : request.axis,
            last = request.axis < 0 ? console_.axes() - 1 : request.axis;
  for (int axis = first; axis <= last; ++axis) {
    if (auto may = console_.has_axis(axis); !may) co_return may;
    auto set = co_await conversation_.command(
        set_command(fill(console_.forms, console_.forms.encoder, axis), request.value.value),
        Priority::intent);
    if (!set) co_return set;
    watch_.encoder_was_set(axis, request.value);
    console_.snapshot.axes[axis].has_target = false;
  }
  co_return co_await status_.read(Priority::intent);
}

}  // namespace hw::arcus
