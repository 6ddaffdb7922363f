// S and A outlast a run and cannot be read. A move with its own speed or acceleration therefore ends by
// restoring the value of the user's last S or A, or the power-up value, 2000 steps/s and 2, if none was seen.
#include "core/devices/vxm/legs.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/axis_motion.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

constexpr double longest_jog_s = 30;  // seconds after which a jog ends by itself (a pulled cable)
constexpr Duration quick_patience = std::chrono::seconds(1);

/// Value to set before a leg; 0: none.
int to_set(const LastSent& last, int axis, int of_leg) {
  if (of_leg > 0) return of_leg;
  return last.is_ours(axis) ? last.usual(axis) : 0;
}

}  // namespace

std::string Legs::leg_program(const Leg& leg) const {
  std::string text;
  for (const int axis : {leg.axis, leg.second_axis}) {
    if (axis < 0) continue;
    if (const int value = to_set(speeds_.speed, axis, leg.pace.speed)) text += speed(axis + 1, value);
    if (const int value = to_set(speeds_.acceleration, axis, leg.pace.acceleration))
      text += acceleration(axis + 1, value);
  }
  text += leg.text;
  for (const int axis : {leg.axis, leg.second_axis}) {
    if (axis < 0) continue;
    if (leg.pace.speed > 0) text += speed(axis + 1, speeds_.speed.usual(axis));
    if (leg.pace.acceleration > 0) text += acceleration(axis + 1, speeds_.acceleration.usual(axis));
  }
  return text;
}

Task<Result<>> Legs::begin(Job job) {
  auto held = co_await hold_switch_.settle();
  if (!held) co_return held;
  if (!knowledge_.suffices_for_a_move()) {
    auto read = co_await knowledge_.catch_up();
    if (!read) co_return read;
  }
  auto found = co_await scratch_.take();
  if (!found) co_return found;
  under_way_.begin(std::move(job));
  co_return co_await start_leg();
}

// Only R begins a motion: it is sent once, after lst has confirmed the program.
Task<Result<>> Legs::start_leg() {
  const Leg& leg = under_way_.job().leg();
  auto filled = co_await scratch_.fill(leg_program(leg));
  if (!filled) co_return never_begun(filled);
  under_way_.job().leg_begins();
  for (const int axis : {leg.axis, leg.second_axis}) {
    if (axis >= 0 && leg.pace.speed > 0) speeds_.speed.borrow(axis);
    if (axis >= 0 && leg.pace.acceleration > 0) speeds_.acceleration.borrow(axis);
  }
  const bool held = hold_.is_on();  // to be switched off: the leg would be held before its first command
  hold_.was_switched(false);
  show_leg(leg);
  auto sent = co_await conversation_.transmit(held ? "HR" : "R", Priority::intent);
  if (sent) co_return sent;
  hold_.was_switched(held);
  if (held && sent.error().kind == FaultKind::lost) hold_.doubt();
  co_return never_begun(sent);
}

/// The leg did not begin: a stop came first, or the program did not arrive.
Result<> Legs::never_begun(const Result<>& why) {
  const Job never = std::exchange(under_way_.job(), Job());
  const FaultKind kind = why.error().kind;
  const EndedBy ended_by = kind == FaultKind::stopped   ? EndedBy::stop
                           : kind == FaultKind::refused ? EndedBy::nothing
                                                        : EndedBy::lost;
  if (never.active()) show_leg_ended(never.leg(), ended_by);
  return why;
}

void Legs::show_leg(const Leg& leg) {
  if (leg.activity == Activity::idle) return;
  for (const int index : {leg.axis, leg.second_axis}) {
    if (index < 0) continue;
    AxisState& axis = console_.snapshot.axes[index];
    begin_motion(axis, leg.activity, index == leg.axis ? leg.target : std::nullopt);
    axis.direction = static_cast<std::int8_t>(factor(leg.sign));
    if (axis.has_target && axis.position_known)
      axis.direction = static_cast<std::int8_t>(axis.target < axis.position ? -1 : 1);
    axis.speed = Pps{static_cast<double>(leg.pace.speed > 0 ? leg.pace.speed : speeds_.speed.known(index))};
    axis.began_at = axis.position;
    axis.ramp = axis.position_known ? ramp_of(leg, index) : 0;
  }
}

/// Steps/s²; 0: not known.
double Legs::ramp_of(const Leg& leg, int axis) const {
  const int units = leg.pace.acceleration > 0 ? leg.pace.acceleration : speeds_.acceleration.usual(axis);
  const ParamState& mode = console_.snapshot.params[ix(console_.catalog.find_param("DM"))];
  if (!mode.known) return 0;
  return units * accel_unit * ((mode.value & mode_nf90) != 0 ? 2 : 1);
}

Task<Result<>> Legs::settle() {
  if (hold_.is_to_be_released()) {
    if (ramp_.is_expected()) co_return Result<>();  // the stop ends the move before it begins
    auto released = co_await hold_switch_.transmit("H", false, Priority::intent);
    if (!released) co_return released;
  }
  hold_.was_released();
  if (under_way_.job().active() && under_way_.job().is_leg_over()) {
    auto ended = co_await end_leg(Priority::poll);
    if (!ended) co_return ended;
    if (under_way_.job().active()) co_return co_await start_leg();
  }
  if (under_way_.busy() || presence_.is_halted() || !presence_.is_on_line()) co_return Result<>();
  auto cleaned = co_await scratch_.clear(Priority::poll);
  if (!cleaned) co_return cleaned;
  co_return co_await slots_.give_back_selection();
}

Task<Result<>> Legs::end_leg(Priority priority) {
  const Leg leg = under_way_.job().leg();
  const bool moved = leg.activity != Activity::idle;
  Result<> read;
  if (moved) read = co_await signals_.ask('?', priority);
  if (read) read = co_await positions_.read(priority, true);
  if (read && moved && !signals_.confirm()) read = co_await signals_.read("?", priority);
  if (!read) co_return read;
  const EndedBy ended_by = end_of_leg(leg);
  const bool cut_off = ended_by == EndedBy::abort || ended_by == EndedBy::error || ended_by == EndedBy::lost;
  for (const int axis : {leg.axis, leg.second_axis})
    if (axis >= 0 && !cut_off) speeds_.speed.give_back(axis), speeds_.acceleration.give_back(axis);
  auto again = next_jog_leg(leg, ended_by);
  under_way_.job().go_on(ended_by, std::move(again));
  show_leg_ended(leg, ended_by);
  ramp_.forget();
  if (!under_way_.job().active()) under_way_.drop_job();
  co_return Result<>();
}

EndedBy Legs::end_of_leg(const Leg& leg) const {
  const bool arrived =
      leg.axis >= 0 && leg.target && console_.snapshot.axes[leg.axis].position == *leg.target;
  if (under_way_.job().ended_by() == EndedBy::stop && under_way_.job().was_cut_whole() && arrived)
    return EndedBy::target;  // the stop came too late
  if (under_way_.job().ended_by() != EndedBy::nothing) return under_way_.job().ended_by();
  if (leg.axis < 0 || leg.activity == Activity::idle) return EndedBy::target;
  const AxisState& axis = console_.snapshot.axes[leg.axis];
  const bool at_limit =
      (axis.direction > 0 ? axis.limit_plus : axis.limit_minus) || under_way_.job().limit_was_reported();
  // Another host may have stopped the search halfway, where the count must not become zero.
  if (leg.to_switch) return at_limit || !axis.limits_known ? EndedBy::target : EndedBy::elsewhere;
  if (leg.activity == Activity::homing || !leg.target || axis.position == *leg.target) return EndedBy::target;
  return at_limit ? EndedBy::limit : EndedBy::elsewhere;
}

void Legs::show_leg_ended(const Leg& leg, EndedBy ended_by) {
  for (const int index : {leg.axis, leg.second_axis}) {
    if (index < 0) continue;
    AxisState& axis = console_.snapshot.axes[index];
    if (leg.activity != Activity::idle) {
      end_motion(axis, ended_by);
      axis.speed = Pps{};
    }
    if (leg.zeroes && ended_by == EndedBy::target) axis.trust.settle(*leg.zeroes, console_.scheduler.now());
  }
}

Leg Legs::jog_leg(int axis, Sign sign, LegPace pace, std::optional<Steps> up_to) const {
  const AxisState& state = console_.snapshot.axes[axis];
  const Catalog& catalog = console_.catalog;
  const Steps end = up_to.value_or(sign == Sign::plus ? catalog.position_max : catalog.position_min);
  const Steps room = std::max(Steps(0), sign == Sign::plus ? end - state.position : state.position - end);
  const std::int64_t distance = std::min<std::int64_t>(std::llround(pace.speed * longest_jog_s), room.value);
  Leg leg;
  leg.axis = axis;
  leg.activity = Activity::jogging;
  leg.sign = sign;
  leg.pace = pace;
  leg.up_to = up_to;
  leg.target = state.position + Steps{factor(sign) * distance};
  leg.text = index_by(axis + 1, Steps{factor(sign) * distance});
  return leg;
}

std::optional<Leg> Legs::next_jog_leg(const Leg& last, EndedBy ended_by) const {
  if (!under_way_.job().is_jog() || ended_by != EndedBy::target) return std::nullopt;
  Leg leg = jog_leg(last.axis, last.sign, last.pace, last.up_to);
  if (*leg.target == console_.snapshot.axes[last.axis].position) return std::nullopt;
  return leg;
}

// Whether the console's program is removed. A move that was not stopped keeps it, however long the move
// takes.
bool Legs::clears_up() const {
  const bool ends = !under_way_.busy() || ramp_.is_expected() || under_way_.job().is_leg_over() ||
                    under_way_.job().ended_by() != EndedBy::nothing;
  const bool something_left =
      scratch_.in_use() || !slots_.selection_is_given_back() || hold_.is_to_be_released();
  return something_left && !presence_.reset_was_sent() && presence_.is_on_line() && !presence_.is_halted() &&
         ends;
}

std::string Legs::leaves_behind() const {
  std::string left = program_left_behind();
  if (!under_way_.program_runs() || !hold_.is_on()) return left;
  if (!left.empty()) left.insert(0, 1, ' ');
  return "The program is left held (H) in the controller, before its next command: another H lets it go "
         "on, K ends it." +
         left;
}

std::string Legs::program_left_behind() const {
  if (presence_.reset_was_sent() || (!scratch_.in_use() && slots_.selection_is_given_back())) return {};
  if (!scratch_.in_use())
    return fmt::format(
        "Send PM{} to select your program: a program that the console used is still selected, and the Run "
        "button would start it.",
        std::max(slots_.selected(), 0));
  return fmt::format(
      "{}program {} of the controller still holds {}: the Run button would repeat it. Send {} when the move "
      "is over.",
      under_way_.job().is_leg_over() ? "The " : "The move goes on without the console, and ", scratch_.slot(),
      under_way_.job().is_leg_over() ? "a move of the console" : "it", empty_program(scratch_.slot()));
}

Task<Result<>> Legs::run_quickly(Leg leg) {
  Job job;
  job.add(std::move(leg));
  auto begun = co_await begin(std::move(job));
  if (!begun) co_return begun;
  const Instant deadline = console_.scheduler.now() + quick_patience;
  bool in_time = true;
  while (conversation_.station() && !conversation_.station()->preempted() && under_way_.job().active() &&
         !under_way_.job().is_leg_over() && in_time)
    in_time = co_await under_way_.news().wait_until(deadline);
  if (auto cut = cut_short(); !cut) co_return cut;
  if (!in_time) {
    auto state = co_await conversation_.state(Priority::intent);
    if (!state) co_return fail(state.error());
    auto taken = co_await status_.take(*state);
    if (!taken) co_return taken;
  }
  co_return co_await settle();
}

Result<> Legs::cut_short() const {
  if (!conversation_.station() || !conversation_.station()->preempted()) return {};
  return fail(FaultKind::stopped, "A stop came while this command was under way.", "The command was sent.");
}

Task<Result<>> Legs::restore_speeds() {
  Leg leg;
  for (int axis = 0; axis < console_.snapshot.axis_count; ++axis) {
    if (const int value = to_set(speeds_.speed, axis, 0)) leg.text += speed(axis + 1, value);
    if (const int value = to_set(speeds_.acceleration, axis, 0)) leg.text += acceleration(axis + 1, value);
  }
  if (leg.text.empty()) co_return Result<>();
  auto restored = co_await run_quickly(std::move(leg));
  if (restored) speeds_.speed.give_all_back(), speeds_.acceleration.give_all_back();
  co_return restored;
}

}  // namespace hw::vxm
