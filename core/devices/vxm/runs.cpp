#include "core/devices/vxm/runs.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {

// The controller reports no limit unless O is set for it. A motor that stands on the switch that it last
// moved towards, and was not sent to find it, was stopped by it.
void Runs::find_end_of_run() {
  const auto slot = under_way_.take_ended_run();
  if (!slot) return;
  console_.snapshot.working = false;
  bool at_limit = false;
  for (int i = 0; i < console_.snapshot.axis_count; ++i) {
    AxisState& axis = console_.snapshot.axes[i];
    const std::optional<Sign> way = readings_.went(i);
    const bool on_switch =
        way && axis.limits_known && (*way == Sign::plus ? axis.limit_plus : axis.limit_minus);
    if (!on_switch || axis.ended_by != EndedBy::nothing || looks_for_switches(*slot, i + 1)) continue;
    axis.ended_by = EndedBy::limit;
    at_limit = true;
  }
  ProgramState& p = console_.snapshot.program;
  if (p.ended_by == EndedBy::nothing) p.ended_by = at_limit ? EndedBy::limit : EndedBy::target;
}

/// The program is known, and its last index of this motor goes to a switch.
bool Runs::looks_for_switches(int slot, int motor) const {
  if (!slots_.listing(slot)) return false;
  bool looks = false;
  for (const TextCommand& c : commands_of(*slots_.listing(slot)))
    if (c.verb <= Verb::home && c.verb != Verb::zero_here && c.motor == motor) looks = c.verb == Verb::home;
  return looks;
}

/// False: the program is known, calls no other, and has no index of this motor.
bool Runs::may_turn(int slot, int motor) const {
  if (!slots_.listing(slot)) return true;
  const auto commands = commands_of(*slots_.listing(slot));
  return std::any_of(commands.begin(), commands.end(), [&](const TextCommand& c) {
    const bool index = c.verb <= Verb::home && c.verb != Verb::zero_here;
    const bool leaves = c.verb >= Verb::jump && c.verb <= Verb::jump_pick;
    return leaves || (index && c.motor == motor);
  });
}

Task<Result<>> Runs::run(int slot) {
  if (auto may = admission_.may_run(); !may) co_return may;
  if (console_.snapshot.slot_bytes_used[ix(slot)] == 0)
    co_return fail(FaultKind::refused, fmt::format("Program {} of the controller is empty.", slot),
                   "Nothing was run.", "Load it first.");
  auto held = co_await hold_switch_.settle();
  if (!held) co_return held;
  auto speeds = co_await legs_.restore_speeds();
  if (!speeds) co_return speeds;
  for (int i = 0; i < console_.snapshot.axis_count; ++i)
    if (may_turn(slot, i + 1)) admission_.warn_of_motor_type(i);
  auto chosen = co_await slots_.choose(slot, Priority::intent);
  if (!chosen) co_return chosen;
  std::string text = hold_.is_on() ? "HR" : "R";
  ramp_.forget();
  auto sent = co_await hold_switch_.transmit(std::move(text), false, Priority::intent);
  if (!sent) co_return sent;
  slots_.was_selected(slot);
  under_way_.program_begins(slot);
  if (slots_.listing(slot))
    for (const TextCommand& c : commands_of(*slots_.listing(slot))) speeds_.note(c);
  co_return sent;
}

Task<Result<>> Runs::pause() {
  if (!under_way_.program_runs())
    co_return fail(FaultKind::refused, "No program is running.", "Nothing was sent.");
  if (auto may = hold_switch_.may_switch(); !may) co_return may;
  if (hold_.is_on()) co_return Result<>();
  auto sent = co_await hold_switch_.transmit("H", true, Priority::intent);
  if (sent) console_.snapshot.program.stepping = true;
  co_return sent;
}

Task<Result<>> Runs::resume() {
  ProgramState& p = console_.snapshot.program;
  if (!under_way_.program_runs())
    co_return fail(FaultKind::refused, "No program is held or waits.", "Nothing was sent.", "Run it.");
  if (auto may = hold_switch_.may_switch(); !may && p.run != RunState::waiting) co_return may;
  if (!hold_.is_on() && p.run != RunState::waiting)
    co_return fail(FaultKind::refused, "The program runs: it is not held and does not wait for G.",
                   "Nothing was sent.",
                   "If it is waiting for an input (U0 and similar), only that input lets it go on.");
  const bool waits = p.run == RunState::waiting;
  auto sent = waits ? co_await conversation_.transmit("G", Priority::intent)
                    : co_await hold_switch_.transmit("H", false, Priority::intent);
  if (!sent) co_return sent;
  if (!waits) p.stepping = false;
  p.run = RunState::running;
  p.command = -1;
  co_return sent;
}

Task<Result<>> Runs::single_step() {
  ProgramState& p = console_.snapshot.program;
  if (!under_way_.program_runs()) {  // starts the program held: nothing moves before the next step
    if (auto may = admission_.may_run(); !may) co_return may;
    auto held = co_await hold_switch_.settle();
    if (!held) co_return held;
    std::string text = hold_.is_on() ? "R" : "HR";
    auto started = co_await hold_switch_.transmit(std::move(text), true, Priority::intent);
    if (!started) co_return started;
    under_way_.program_begins(slots_.selected());
    co_return started;
  }
  if (p.run != RunState::held) co_return co_await pause();
  auto sent = co_await conversation_.transmit("G", Priority::intent);
  if (sent) p.run = RunState::running;
  co_return sent;
}

}  // namespace hw::vxm
