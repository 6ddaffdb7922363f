// Runs of stored programs: starting, holding, going on, single steps.
#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vxm/driver.h"

namespace hw::vxm {

Result<> VxmDriver::may_change() const {
  if (halted_)
    return fail(FaultKind::refused, explain_error(halted_).what, "Nothing was sent.",
                explain_error(halted_).advice);
  if (busy())
    return fail(FaultKind::refused, "The controller is at work and takes no program commands meanwhile.",
                "Nothing was sent.", "Wait until it ends, or stop it.");
  return {};
}

void VxmDriver::show_running(int slot) {
  stored_running_ = true;
  hold_.nothing_runs_from_before();
  killed_at_ = {};  // the next prompt is of this run
  ProgramState& p = draft_.program;
  p.run = RunState::running;
  p.owned = true;
  p.slot = static_cast<std::int8_t>(slot >= 0 ? slot : slots_.selected());
  p.command = -1;
  p.command_told = false;
  p.stepping = hold_.is_on();
  p.started_at = scheduler_.now();
  forget_how_it_ended();
  sight_.forget_ways();
  ended_run_.reset();
  draft_.working = false;
}

// The controller says nothing of a limit unless O tells it to. A motor that stands on the switch that it went
// towards last, and was not sent to look for it, was stopped by it.
void VxmDriver::look_what_ended_the_run() {
  const auto slot = std::exchange(ended_run_, std::nullopt);
  if (!slot) return;
  draft_.working = false;
  for (int i = 0; i < draft_.axis_count; ++i) {
    AxisState& axis = draft_.axes[i];
    const std::optional<Sign> way = sight_.went(i);
    const bool on_switch =
        way && axis.limits_known && (*way == Sign::plus ? axis.limit_plus : axis.limit_minus);
    if (on_switch && axis.ended_by == EndedBy::nothing && !looks_for_switches(*slot, i + 1))
      axis.ended_by = EndedBy::limit;
  }
}

/// The program is known, and its last index of this motor goes to a switch.
bool VxmDriver::looks_for_switches(int slot, int motor) const {
  if (!slots_.listing(slot)) return false;
  bool looks = false;
  for (const TextCommand& c : commands_of(*slots_.listing(slot)))
    if (c.verb <= Verb::home && c.verb != Verb::zero_here && c.motor == motor) looks = c.verb == Verb::home;
  return looks;
}

/// False: the program is known, goes into no other, and has no index of this motor.
bool VxmDriver::may_turn(int slot, int motor) const {
  if (!slots_.listing(slot)) return true;
  const auto commands = commands_of(*slots_.listing(slot));
  return std::any_of(commands.begin(), commands.end(), [&](const TextCommand& c) {
    const bool index = c.verb <= Verb::home && c.verb != Verb::zero_here;
    const bool leaves = c.verb >= Verb::jump && c.verb <= Verb::jump_pick;
    return leaves || (index && c.motor == motor);
  });
}

Task<Result<>> VxmDriver::run(int slot) {
  if (auto may = may_run(); !may) co_return may;
  if (draft_.slot_bytes_used[ix(slot)] == 0)
    co_return fail(FaultKind::refused, fmt::format("Program {} of the controller is empty.", slot),
                   "Nothing was run.", "Load it first.");
  auto held = co_await settle_hold();
  if (!held) co_return held;
  auto speeds = co_await restore_speeds();
  if (!speeds) co_return speeds;
  for (int i = 0; i < draft_.axis_count; ++i)
    if (may_turn(slot, i + 1)) warn_of_motor_type(i);
  auto chosen = co_await slots_.choose(slot, Priority::intent);
  if (!chosen) co_return chosen;
  std::string text = hold_.is_on() ? "HR" : "R";
  ramp_.reset();
  auto sent = co_await switch_hold(std::move(text), false, Priority::intent);
  if (!sent) co_return sent;
  slots_.was_selected(slot);
  show_running(slot);
  if (slots_.listing(slot))
    for (const TextCommand& c : commands_of(*slots_.listing(slot)))
      if (c.verb == Verb::speed) speeds_.was_set(c.motor, static_cast<int>(c.value));
  co_return sent;
}

/// None of what is held does.
void VxmDriver::program_has_begun_a_way(bool reversed) {
  constexpr Duration shown_by_then = Millis(150);  // what had begun when the hold was told
  hold_.something_begins();
  if (ramp_ && reversed && scheduler_.now() - ramp_->began > shown_by_then) ramp_->reversed = true;
  if (ramp_ || hold_.is_known()) return;
  hold_.is_seen_off();
}

// H is a switch: it is said only when it changes what is wanted.
Task<Result<>> VxmDriver::switch_hold(std::string text, bool on, Priority priority) {
  const bool switches = text.starts_with('H');
  auto said = co_await talk_.say(std::move(text), priority);
  if (said) hold_.was_switched(on);
  if (!said && switches && said.error().kind == FaultKind::lost) hold_.doubt();
  co_return said;
}

Result<> VxmDriver::may_switch_hold() const {
  if (hold_.is_known()) return {};
  return fail(FaultKind::refused,
              hold_.is_doubtful()
                  ? "The connection was lost while the hold was switched: whether it is on is not known."
                  : "Somebody else has begun this program, and whether it is held shows when a motor starts.",
              "Nothing was sent.", "Stop the program.");
}

Task<Result<>> VxmDriver::pause() {
  if (!stored_running_) co_return fail(FaultKind::refused, "No program is running.", "Nothing was sent.");
  if (auto may = may_switch_hold(); !may) co_return may;
  if (hold_.is_on()) co_return Result<>();
  auto said = co_await switch_hold("H", true, Priority::intent);
  if (said) draft_.program.stepping = true;
  co_return said;
}

Task<Result<>> VxmDriver::resume() {
  ProgramState& p = draft_.program;
  if (!stored_running_)
    co_return fail(FaultKind::refused, "No program is held or waits.", "Nothing was sent.", "Run it.");
  if (auto may = may_switch_hold(); !may && p.run != RunState::waiting) co_return may;
  if (!hold_.is_on() && p.run != RunState::waiting)
    co_return fail(FaultKind::refused, "The program runs: it is not held and does not wait for G.",
                   "Nothing was sent.",
                   "If it stands in a wait for an input (U0 and its like), only that input lets it go on.");
  const bool waits = p.run == RunState::waiting;
  auto said =
      waits ? co_await talk_.say("G", Priority::intent) : co_await switch_hold("H", false, Priority::intent);
  if (!said) co_return said;
  if (!waits) p.stepping = false;
  p.run = RunState::running;
  p.command = -1;
  co_return said;
}

Task<Result<>> VxmDriver::single_step() {
  ProgramState& p = draft_.program;
  if (!stored_running_) {  // start it held: nothing moves before the next step
    if (auto may = may_run(); !may) co_return may;
    auto held = co_await settle_hold();
    if (!held) co_return held;
    std::string text = hold_.is_on() ? "R" : "HR";
    auto started = co_await switch_hold(std::move(text), true, Priority::intent);
    if (!started) co_return started;
    show_running(slots_.selected());
    co_return started;
  }
  if (p.run != RunState::held) co_return co_await pause();
  auto said = co_await talk_.say("G", Priority::intent);
  if (said) p.run = RunState::running;
  co_return said;
}

}  // namespace hw::vxm
