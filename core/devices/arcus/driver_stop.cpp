// Stopping, by decision AMB-128: STOP (or ABORT), every program stopped, the joystick off where it is on,
// STOP again because a program or the stick may have begun a move in between, then the status until all
// stand.
#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {
namespace {

constexpr Duration longest_stop = std::chrono::seconds(30);  // of a ramp that the user made long
constexpr Duration look_again = Millis(40);
constexpr int stop_attempts = 3;

}  // namespace

// A stop may be repeated: it moves nothing.
Task<Result<>> ArcusDriver::say_stop(std::string text) {
  Result<> said;
  for (int attempt = 0; attempt < stop_attempts; ++attempt) {
    said = co_await command(text, Priority::stop);
    if (said || said.error().kind == FaultKind::lost) break;
  }
  co_return said;
}

void ArcusDriver::stopping(int axis, bool at_once) {
  for (int i = 0; i < axis_count(); ++i) {
    if ((axis >= 0 && i != axis) || !moving(i)) continue;
    ended_by_us(i, at_once ? EndedBy::abort : EndedBy::stop);
    draft_.axes[i].activity = Activity::stopping;
    minds_[ix(i)].stopping = true;
  }
}

// Axes that move together end together.
void ArcusDriver::ended_by_us(int axis, EndedBy why) {
  for (int i = 0; i < axis_count(); ++i) {
    if (!moving(i) || (i != axis && (minds_[ix(axis)].with >> i & 1u) == 0)) continue;
    minds_[ix(i)].ended_by = why;
    if (why == EndedBy::abort) doubt_killed_position(i);
  }
}

// Its pulses end with ABORT, not its mass: a step motor stays in step only up to the speed at which it starts
// without a ramp too. With StepNLoop the encoder counts what it did.
void ArcusDriver::doubt_killed_position(int index) {
  AxisState& axis = draft_.axes[index];
  const std::int64_t safe = start_speed(index);
  if (axis.in_counts || axis.trust.doubtful() || axis.speed.value <= static_cast<double>(safe)) return;
  axis.trust.doubt(Doubt::killed, scheduler_.now());
  tell(Notice::Kind::warning,
       fmt::format("Axis {} was stopped without a ramp at {:.0f} pulses/s. Above its low speed, {}, it may "
                   "have lost steps: its position is doubtful until it is homed or set.",
                   axis_name(index), axis.speed.value, safe));
}

Task<Result<>> ArcusDriver::stop(int axis, bool at_once) {
  const bool asked_twice = stops_.ramps(axis);
  co_return co_await stop_what(axis, at_once || asked_twice, false);
}

// What the jog moves stops; programs, and axes that they move, go on. Letting go is never the second stop.
Task<Result<>> ArcusDriver::stop_jog(int axis) { co_return co_await stop_what(axis, false, true); }

Task<Result<>> ArcusDriver::stop_what(int axis, bool at_once, bool motion_only) {
  if (!station_)
    co_return fail(FaultKind::lost, "Stop does not reach the controller: there is no connection.",
                   "Nothing was sent.", "Use its power switch.");
  stops_.begin(axis, at_once);
  stop_is_said(axis, at_once ? EndedBy::abort : EndedBy::stop);
  auto stopped = co_await stop_now(axis, at_once, motion_only);
  stops_.end(axis, at_once);
  if (station_) stands(axis);
  co_return stopped;
}

// Also what is on its way out just now, and does not move yet, is ended by it.
void ArcusDriver::stop_is_said(int axis, EndedBy how) {
  end_feed();
  latest_stop_ = how;
  for (int i = 0; i < axis_count(); ++i)
    if (axis < 0 || i == axis) ++stops_said_[ix(i)];
}

// What was being stopped is shown as it is again.
void ArcusDriver::stands(int axis) {
  for (int i = 0; i < axis_count(); ++i) {
    if (axis >= 0 && i != axis) continue;
    minds_[ix(i)].stopping = false;
    show_axis(i, scheduler_.now());
  }
}

Task<Result<>> ArcusDriver::stop_now(int axis, bool at_once, bool motion_only) {
  const std::string_view form = at_once ? forms_.abort : forms_.stop;
  const bool all = axis < 0 || axis_count() == 1;
  const std::string word = all ? std::string(form.substr(0, form.find('a'))) : fill(forms_, form, axis);
  stopping(axis, at_once);
  Result<> said;
  if (motion_only)
    said = co_await say_stop(word);
  else
    said = co_await say_stops(word, axis, all);
  if (!said) co_return said;
  if (all && !motion_only && subroutine_may_run()) co_return co_await outlast_subroutine(word);
  co_return co_await wait_for_standstill(all ? -1 : axis);
}

Task<Result<>> ArcusDriver::say_stops(std::string word, int axis, bool all) {
  Result<> said;
  for (int attempt = 0; attempt < stop_attempts; ++attempt) {
    said = co_await say_each_once(word, axis, all);
    if (said) break;
    if (!station_)
      co_return fail(FaultKind::lost, "The connection was lost while the controller was told to stop.",
                     "Whether it has heard all of it is not known.", "Use its power switch if it moves.");
  }
  co_return said;
}

// Whatever is not confirmed, the next is sent: each answer that is waited for keeps back the others.
Task<Result<>> ArcusDriver::say_each_once(std::string word, int axis, bool all) {
  auto said = co_await command(word, Priority::stop);
  Result<> halted, rest;
  if (all) {
    halted = co_await halt_threads(-1);
    said = co_await command(word, Priority::stop);
  }
  auto released = co_await release_joystick(all ? -1 : axis, word);
  if (all) rest = co_await threads_rest();
  if (!said) co_return said;
  if (!halted) co_return halted;
  co_return released ? rest : released;
}

// A stop for all devices of the line in one message; the stop of each follows.
Task<Result<>> ArcusDriver::stop_wire(bool at_once) {
  if (model().broadcast < 0) co_return Result<>();
  co_return co_await broadcast(at_once ? "ABORT" : "STOP", Priority::stop);
}

namespace {

Fault joystick_not_read(bool switched_off) {
  return Fault(FaultKind::garbled, "The controller did not tell which axes follow the joystick.",
               switched_off ? "STOP was sent, and the joystick was switched off for all axes."
                            : "STOP was sent; the joystick was left as it is.",
               switched_off ? "" : "Stop all axes if this one goes on.");
}

}  // namespace

// Its axes would go on by the stick. It is asked each time: programs, other hosts and a power-up switch it
// on.
Task<Result<>> ArcusDriver::release_joystick(int axis, std::string stop) {
  if (!forms_.joystick) co_return Result<>();
  const int index = catalog_.find_param("JE");
  const auto mask = co_await ask_number("JE", Priority::stop);
  if (!mask && mask.error().kind == FaultKind::lost) co_return fail(mask.error());
  const std::int64_t kept = axis < 0 || !mask ? 0 : *mask & ~(std::int64_t{1} << axis);
  if (mask && kept == *mask) co_return Result<>();
  if (!mask && axis >= 0) {
    draft_.params[ix(index)].known = false;
    co_return fail(joystick_not_read(false));
  }
  const auto set = co_await command(set_command("JE", kept), Priority::stop);
  changed_param(index);
  auto said = co_await command(stop, Priority::stop);
  if (!set) co_return set;
  if (!mask) co_return fail(joystick_not_read(true));
  draft_.params[ix(index)].value = kept;
  draft_.params[ix(index)].known = true;
  tell(Notice::Kind::info, "The joystick was switched off by the stop.");
  co_return said;
}

// One, or all (-1): also those that were idle when they were last asked. A program, another host or the
// power-up may have started them.
Task<Result<>> ArcusDriver::halt_threads(int only) {
  Result<> halted;
  for (int n = 0; n < model().programs; ++n) {
    if (only >= 0 && n != only) continue;
    auto said = co_await command(fmt::format("SR{}=0", n), Priority::stop);
    if (!said && halted) halted = std::move(said);
  }
  co_return halted;
}

// One that was halted is started again by another that is not yet.
Task<Result<>> ArcusDriver::threads_rest() {
  auto read = co_await read_threads(true, Priority::stop);
  if (!read) co_return read;
  for (int n = 0; n < model().programs; ++n) {
    const RunState run = draft_.threads[ix(n)].run;
    if (run != RunState::running && run != RunState::held) continue;
    co_return fail(FaultKind::controller, fmt::format("Program {} still runs: something starts it again.", n),
                   fmt::format("It was told to stop {} times.", stop_attempts),
                   "Stop again, or switch the power off.");
  }
  co_return Result<>();
}

Task<Result<>> ArcusDriver::wait_for_standstill(int axis) {
  const Instant give_up = scheduler_.now() + longest_stop;
  for (;;) {
    auto read = co_await read_motion(Priority::stop);
    if (!read) co_return read;
    auto loop = co_await read_loop(Priority::stop);
    if (!loop) co_return loop;
    bool turns = false;
    for (int i = 0; i < axis_count(); ++i) turns = turns || ((axis < 0 || i == axis) && runs(i));
    if (!turns) co_return Result<>();
    if (scheduler_.now() > give_up)
      co_return fail(FaultKind::controller, "The controller was told to stop and still moves.",
                     "The stop was sent.", "Stop again: it then stops at once, without a ramp.");
    co_await scheduler_.sleep_for(look_again);  // not until the next look: two stops would chase each other
    if (!station_) co_return fail(FaultKind::lost, "The connection was lost while the axes were stopping.");
  }
}

// The program ends; the motion that it has begun goes on.
Task<Result<>> ArcusDriver::halt_program(int thread) {
  if (!station_) co_return no_connection();
  if (thread >= model().programs)
    co_return fail(FaultKind::refused, fmt::format("There is no program {}.", thread), "Nothing was sent.");
  Result<> halted;
  for (int attempt = 0; attempt < stop_attempts; ++attempt) {
    halted = co_await halt_threads(thread);
    if (halted || !station_) break;
  }
  if (!halted) co_return halted;
  co_return co_await read_threads(true, Priority::stop);
}

}  // namespace hw::arcus
