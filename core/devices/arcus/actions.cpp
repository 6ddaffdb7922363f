#include "core/devices/arcus/actions.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/action_check.h"

namespace hw::arcus {
namespace {

/// The value of the field `id`, or `fallback` where the action has none.
std::int64_t field(const ActionInfo& info, const std::vector<std::int64_t>& values, std::string_view id,
                   std::int64_t fallback = 0) {
  for (std::size_t i = 0; i < info.fields.size(); ++i)
    if (info.fields[i].id == id) return values[i];
  return fallback;
}

}  // namespace

Task<Result<>> Actions::act(intent::Act request) {
  if (auto possible = check_action(console_.catalog, request); !possible) co_return possible;
  const ActionInfo& info = console_.catalog.actions[ix(request.action)];
  const auto value = [&](std::string_view id) { return field(info, request.values, id); };
  const int axis = static_cast<int>(value("axis"));
  const bool on = value("on") != 0;
  const std::string& id = info.id;

  if (id == "clear") co_return co_await clear_errors(console_.forms.clear, axis);
  if (id == "change_speed") co_return co_await change_speed(axis, value("speed"), value("accel"));
  if (id == "arc") co_return co_await draw_arc(value("centre_x"), value("centre_y"), value("sweep"));
  if (id == "joystick") co_return co_await joystick(axis, on);
  if (id == "change_target") co_return co_await change_target(axis, value("target"));

  std::string text;
  if (id == "absolute") text = "ABS";
  if (id == "incremental") text = "INC";
  if (id == "latch") text = set_command(fill(console_.forms, console_.forms.latch, axis), on);
  if (id == "sync") text = fill(console_.forms, on ? console_.forms.sync_on : console_.forms.sync_off, axis);
  if (id == "subroutine") text = fmt::format("GS{}", value("number"));
  if (id == "buffer_on") text = "BO";
  if (id == "buffer_off") text = "BF";
  if (id == "timer") text = set_command("TR", value("time"));
  auto done = co_await conversation_.command(text, Priority::intent);
  if (!done) {
    if (info.moves) {
      Fault fault = co_await status_.after_doubt(std::move(done.error()), text);
      co_return fail(std::move(fault));
    }
    co_return done;
  }
  if (id == "absolute" || id == "incremental") readouts_.put("MM", id == "incremental");
  if (id == "buffer_off") list_.end();
  co_return Result<>();
}

// Positions stay as they are; the target of StepNLoop becomes the present place of the axis.
Task<Result<>> Actions::clear_errors(std::string_view form, int axis) {
  const bool all = axis < 0 || console_.axes() == 1;
  std::string text = all ? std::string(form.substr(0, form.find('a'))) : fill(console_.forms, form, axis);
  auto done = co_await conversation_.command(std::move(text), Priority::intent);
  if (!done) co_return done;
  for (int i = 0; i < console_.axes(); ++i)
    if (all || i == axis) motions_.loop_is_unknown(i);
  auto read = co_await status_.read(Priority::intent);
  if (!read) co_return read;
  co_return co_await status_.read_loops(Priority::intent);
}

// The ramp takes the acceleration time: a given ramp time is written for this change and restored afterwards.
Task<Result<>> Actions::change_speed(int axis, std::int64_t speed, std::int64_t accel_ms) {
  if (accel_ms > 0) {
    std::string name(console_.forms.accel);
    if (console_.forms.axis_speeds) {
      auto own = co_await conversation_.ask_number(fill(console_.forms, console_.forms.axis_accel, axis),
                                                   Priority::intent);
      if (!own) co_return fail(own.error());
      if (*own != 0) name = fill(console_.forms, console_.forms.axis_accel, axis);
    }
    const auto shown = setup_.param(name);
    auto borrowed = co_await borrowed_.borrow(std::move(name), accel_ms, shown);
    if (!borrowed) co_return borrowed;
  }
  const std::string text = fill(console_.forms, console_.forms.change_speed, axis, Sign::plus, speed);
  auto changed = co_await conversation_.command(text, Priority::intent);
  auto returned = co_await borrowed_.give_back();
  if (changed && !returned) co_return returned;
  if (!changed && changed.error().kind == FaultKind::refused)
    changed.error().advice =
        "Choose the window before the motion begins, then change the speed while the axis moves.";
  co_return changed;
}

Task<Result<>> Actions::change_target(int axis, std::int64_t target) {
  const std::string text = fill(console_.forms, console_.forms.change_target, axis, Sign::plus, target);
  auto done = co_await conversation_.command(text, Priority::intent);
  if (!done) {
    Fault fault = co_await status_.after_doubt(std::move(done.error()), text);
    co_return fail(std::move(fault));
  }
  motions_.goes_elsewhere(axis, Steps(target));
  co_return Result<>();
}

// The controller needs the end of the arc as an angle, clockwise from the minus side of X; it follows from
// the present positions.
Task<Result<>> Actions::draw_arc(std::int64_t centre_x, std::int64_t centre_y, std::int64_t sweep) {
  if (sweep == 0)
    co_return fail(FaultKind::refused, "An arc must sweep more than 0 degrees.", "Nothing was sent.");
  auto incremental = co_await moves_.ask_incremental();
  if (!incremental) co_return fail(incremental.error());
  if (*incremental)
    co_return fail(FaultKind::refused,
                   "Arcs and circles need absolute mode, and the controller is in incremental mode.",
                   "Nothing was sent.", "Choose absolute mode first.");
  const bool circle = sweep == full_turn || sweep == -full_turn;
  std::string text =
      fmt::format("{}{}{}:{}", circle ? "CIR" : "ARC", sweep < 0 ? 'P' : 'N', centre_x, centre_y);
  if (!circle) {
    const auto x = co_await moves_.ask_position(0);
    if (!x) co_return fail(x.error());
    const auto y = co_await moves_.ask_position(1);
    if (!y) co_return fail(y.error());
    const double begin = std::atan2(static_cast<double>(*y - centre_y), static_cast<double>(*x - centre_x));
    const std::int64_t from = full_turn / 2 - std::llround(begin * (full_turn / 2) / std::numbers::pi);
    const std::int64_t end = ((from - sweep) % full_turn + full_turn) % full_turn;
    text += fmt::format(":{}:{}", end, std::abs(sweep));
  }
  std::vector<int> axes{0, 1};
  auto started = co_await moves_.start(std::move(text), std::move(axes), Activity::moving);
  if (!started && started.error().kind == FaultKind::refused && started.error().advice.empty())
    started.error().advice = fmt::format(
        "The radius must be 1 to {} pulses. StepNLoop of X and Y must be off for both, or on for both with "
        "the same ratio.",
        max_radius);
  co_return started;
}

Task<Result<>> Actions::joystick(int axis, bool on) {
  auto mask = co_await conversation_.ask_number("JE", Priority::intent);
  if (!mask) co_return fail(mask.error());
  const std::int64_t bit = std::int64_t{1} << axis;
  auto set =
      co_await conversation_.command(set_command("JE", on ? *mask | bit : *mask & ~bit), Priority::intent);
  if (!set) co_return set;
  const int index = console_.catalog.find_param("JE");
  setup_.changed(index);
  co_return co_await setup_.read(index, Priority::intent);
}

}  // namespace hw::arcus
