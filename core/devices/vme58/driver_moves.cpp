// Moves, jogs, homing, positions, power, outputs, and the catalog's actions.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {

// ---- may it

Result<> Vme58Driver::may_move(int axis) const {
  if (auto may = commands_.may_talk(); !may) return may;
  if (axis < 0 || axis >= axis_count())
    return fail(FaultKind::refused, fmt::format("There is no axis {} here.", axis + 1), "Nothing was sent.");
  if (draft_.program.run == RunState::running)
    return fail(FaultKind::refused, "A program is running.", "Nothing was sent.",
                "Wait until it ends, or stop it.");
  const AxisMind& mind = minds_[ix(axis)];
  // One that only settles may be sent on: a hand that taps is not made to wait for each of its steps.
  if (mind.ours && mind.wanted != Activity::jogging && !(settles(axis) && mind.servo.place.settles()))
    return fail(FaultKind::refused, fmt::format("Axis {} is still moving.", axis_name(axis)),
                "Nothing was sent.", "Wait until it ends, or stop it.");
  return {};
}

Result<std::int64_t> Vme58Driver::checked_speed(Pps speed) const {
  const auto whole = static_cast<std::int64_t>(std::llround(speed.value));
  if (whole == 0 && speed.value == 0) return 0;
  if (whole < 1 || whole > velocity_max)
    return fail(FaultKind::refused,
                fmt::format("{:g} counts/s is not possible: a VME58 axis takes 1 to {} counts/s.",
                            speed.value, velocity_max),
                "Nothing was sent.");
  return whole;
}

// ---- moves

/// The text that starts it, and what is known of it until the board says more.
Task<Result<>> Vme58Driver::begin(std::string text, unsigned axes, Activity activity,
                                  std::array<Steps, max_axes> targets) {
  forget_rejection();
  draft_.program.ended_by = EndedBy::nothing;  // what is told from here on is how this ends
  std::array<Activity, max_axes> before{};
  for (int i = 0; i < axis_count(); ++i) {
    if ((axes >> i & 1) == 0) continue;
    AxisMind& mind = minds_[ix(i)];
    before[ix(i)] = std::exchange(mind.wanted, activity);
    mind.ours = true;
    if (activity != Activity::homing) mind.at_home = AtHome::nothing;
    mind.group = (axes & (axes - 1)) != 0 ? axes : 0;
    mind.done = mind.limit_hit = mind.turned = mind.stopping = mind.by_text = mind.asks_queue = false;
    if (activity != Activity::jogging) begins_to_creep(i, {});
    if (!moving(i)) mind.from_limit = (limits_ >> i & 1) != 0;
    mind.still_since = now();
    mind.servo.goes_to_place = activity != Activity::jogging;
    mind.servo.settling = false;
    AxisState& axis = draft_.axes[i];
    axis.activity = activity;
    axis.ended_by = EndedBy::nothing;
    axis.has_target = activity == Activity::moving;
    axis.target = targets[ix(i)];
  }
  auto sent = co_await commands_.say(std::move(text), Priority::intent);
  if (sent) co_return sent;
  const bool may_begin = wire_.perhaps_done(sent.error());
  for (int i = 0; i < axis_count(); ++i)
    if ((axes >> i & 1) != 0) {
      AxisMind& mind = minds_[ix(i)];
      mind.ours = moving(i) && mind.ours;
      mind.by_text = may_begin;
      mind.wanted = before[ix(i)];  // what still moves is what it was
      mind.at_home = AtHome::nothing;
      draft_.axes[i].has_target = false;
      show_still(i, now());
    }
  if (may_begin) draft_.working = queues_due_ = true;
  co_return sent;
}

// One axis by itself; several on a straight line, as a group of AM beside which others may run.
Task<Result<>> Vme58Driver::move(std::vector<AxisTarget> wish, Pps speed_wish, bool relative) {
  const auto speed = checked_speed(speed_wish);
  if (!speed) co_return fail(speed.error());
  std::array<std::optional<std::int64_t>, most_axes> operands{};
  std::array<Steps, max_axes> targets{};
  unsigned axes = 0;
  for (const AxisTarget& t : wish) {
    const int axis = t.axis.index;
    if (auto may = may_move(axis); !may) co_return may;
    const std::int64_t goal = relative ? draft_.axes[axis].command.value + t.value.value : t.value.value;
    if (std::abs(goal) > position_max)
      co_return fail(FaultKind::refused,
                     fmt::format("Position {} of axis {} lies outside the board's range, ±{}.", goal,
                                 axis_name(axis), position_max),
                     "Nothing was sent.");
    if (relative && t.value.value == 0) continue;
    operands[ix(axis)] = t.value.value;
    targets[ix(axis)] = Steps(goal);
    axes |= 1u << axis;
  }
  if (axes == 0) co_return Result<>();
  const std::string_view letters = relative ? "MR" : "MA";
  const bool alone = (axes & (axes - 1)) == 0;
  std::string text;
  int only = 0;
  while (alone && (axes >> only & 1) == 0) ++only;
  for (int i = 0; i < axis_count(); ++i) {
    if ((axes >> i & 1) == 0) continue;
    Result<> set;
    if (*speed > 0)
      set = co_await borrow_velocity(i, *speed);
    else
      set = co_await give_speed_back(i, Priority::intent);
    if (!set) co_return set;
  }
  if (*speed > 0) {
    // VL waits in the queue like the move, so it can be put back behind it: by whoever sees it end.
    std::array<std::optional<std::int64_t>, most_axes> speeds{};
    for (int i = 0; i < axis_count(); ++i)
      if ((axes >> i & 1) != 0) speeds[ix(i)] = *speed;
    text = alone ? fmt::format("VL{} ", *speed) : encode_list("VL", speeds) + " ";
  }
  if (alone) {
    text += fmt::format("{}{} GD ID", letters, *operands[ix(only)]);
    text = addressed(only, text);
  } else {
    text += encode_list(letters, operands) + " GD ID";
    text = selection_.addressed("AM", text);
  }
  co_return co_await begin(std::move(text), axes, Activity::moving, targets);
}

Task<Result<>> Vme58Driver::jog(intent::JogStart wish) {
  const int axis = wish.axis.index;
  if (auto may = may_move(axis); !may) co_return may;
  auto speed = checked_speed(wish.speed);
  if (!speed) co_return fail(speed.error());
  if (*speed == 0) {
    auto read = co_await read_velocity(axis, Priority::intent);
    if (!read) co_return read;
  }
  if (*speed == 0) speed = std::max<std::int64_t>(1, own_velocity_of(axis));
  minds_[ix(axis)].jog_gap = jog_gap(axis, static_cast<double>(*speed));
  std::string text = addressed(axis, fmt::format("JG{}", factor(wish.sign) * *speed));
  co_return co_await begin_jog(std::move(text), axis);
}

// Whoever is told that his jog has not begun will not stop it. A command error may be another command's, seen
// while the jog waited in the ring: the axis is stopped then, by itself, and if it stands nothing happens.
Task<Result<>> Vme58Driver::begin_jog(std::string text, int axis) {
  const std::array<Steps, max_axes> nowhere{};
  auto begun = co_await begin(std::move(text), 1u << axis, Activity::jogging, nowhere);
  if (begun) co_return begun;
  FaultKind& kind = begun.error().kind;
  if (kind == FaultKind::no_answer) {
    // What the ring did not take was taken back, unless the board was just coming to it.
    const auto read = co_await readings_.read_axes(Priority::intent);
    if (read && !moving(axis)) kind = FaultKind::refused;
  } else if (kind == FaultKind::controller) {
    stopping(axis, false);  // also a jog before it
    std::string stop = addressed(axis, "ST");
    const auto stopped = co_await conversation_.write(std::move(stop), Priority::intent);
    if (!stopped) kind = stopped.error().kind == FaultKind::lost ? FaultKind::lost : FaultKind::no_answer;
  }
  co_return begun;
}

// CA first: a done flag of an earlier motion says nothing of this one.
Task<Result<>> Vme58Driver::home(intent::Home wish) {
  const int axis = wish.axis.index;
  if (auto may = may_move(axis); !may) co_return may;
  const bool plus = wish.sign == Sign::plus;
  std::string text;
  switch (static_cast<HomeMode>(wish.mode)) {
    case HomeMode::edge: text = plus ? "HM0 ID" : "HR0 ID"; break;
    case HomeMode::back_to_edge: text = plus ? "HM0 MA0 GO ID" : "HR0 MA0 GO ID"; break;
    case HomeMode::stop_dead: text = plus ? "KM ID" : "KR ID"; break;
    default:
      co_return fail(FaultKind::refused, fmt::format("There is no way of homing number {}.", wish.mode),
                     "Nothing was sent.");
  }
  auto own = co_await give_speed_back(axis, Priority::intent);
  if (!own) co_return own;
  text = addressed(axis, "CA " + text);
  const bool dead = static_cast<HomeMode>(wish.mode) == HomeMode::stop_dead;
  minds_[ix(axis)].at_home = dead ? AtHome::stops_dead : AtHome::sets_counter;
  const std::array<Steps, max_axes> nowhere{};
  co_return co_await begin(std::move(text), 1u << axis, Activity::homing, nowhere);
}

// ---- positions, power, outputs

Task<Result<>> Vme58Driver::set_position(intent::SetPosition wish) {
  if (auto may = commands_.may_talk(); !may) co_return may;
  if (std::abs(wish.value.value) > position_max)
    co_return fail(FaultKind::refused,
                   fmt::format("{} lies outside the board's range, ±{}.", wish.value.value, position_max),
                   "Nothing was sent.");
  auto loaded = co_await load_positions(wish.axis, wish.value);
  if (!loaded) co_return loaded;
  for (int i = 0; i < axis_count(); ++i)
    if (wish.axis < 0 || wish.axis == i) trusted(i, Trust::set);
  co_return Result<>();
}

// HN closes the loop of a servo axis, HF opens it: the motor is free then.
Task<Result<>> Vme58Driver::set_power(intent::SetPower wish) {
  if (auto may = commands_.may_talk(); !may) co_return may;
  for (int i = 0; i < axis_count(); ++i) {
    if (wish.axis >= 0 && wish.axis != i) continue;
    if (!catalog_.axes[ix(i)].switchable) {
      if (wish.axis < 0) continue;
      co_return fail(
          FaultKind::refused,
          fmt::format("Axis {} is no servo axis: the board does not switch its motor.", axis_name(i)),
          "Nothing was sent.");
    }
    auto switched = co_await switch_loop(i, wish.on, wish.closing);
    if (!switched) co_return switched;
  }
  co_return Result<>();
}

// On is low for a general line (BL), and high for an auxiliary one (AN): the maker's own words.
Task<Result<>> Vme58Driver::set_output(intent::SetOutput wish) {
  if (auto may = commands_.may_talk(); !may) co_return may;
  const int place = catalog_.find_output(wish.number);
  if (place < 0)
    co_return fail(FaultKind::refused, fmt::format("There is no output {} on this board.", wish.number),
                   "Nothing was sent.");
  std::string text;
  const int aux = wish.number - first_auxiliary;
  if (aux >= 0)
    text = addressed(aux, wish.on ? "AN" : "AF");
  else
    text = fmt::format("{}{}\n", wish.on ? "BL" : "BH", wish.number);
  auto sent = co_await commands_.say(std::move(text), Priority::intent);
  const std::uint32_t mask = 1u << place;
  if (!sent && aux >= 0 && wire_.perhaps_done(sent.error())) draft_.outputs_known &= ~mask;
  if (!sent) co_return sent;
  if (aux >= 0) {
    draft_.outputs = wish.on ? draft_.outputs | mask : draft_.outputs & ~mask;
    draft_.outputs_known |= mask;
    co_return Result<>();
  }
  const auto registers = co_await readings_.read_registers(Priority::intent, false);
  if (!registers) co_return fail(registers.error());
  readings_.take(*registers);
  if ((draft_.outputs_known & mask) == 0 || ((draft_.outputs & mask) != 0) == wish.on) co_return Result<>();
  co_return fail(FaultKind::controller,
                 fmt::format("Output {} was to go {}, but its line still reads {}.", wish.number,
                             wish.on ? "on (low)" : "off (high)", wish.on ? "high" : "low"),
                 "It was asked for once.",
                 "A command queue may be busy: it waits there. Or the line is jumpered as an input.");
}

}  // namespace hw::vme58
