#include "core/devices/vxm/under_way.h"

#include "core/device/axis_motion.h"

namespace hw::vxm {

void UnderWay::begin(Job job) {
  ramp_.forget();
  forget_how_it_ended();
  job_ = std::move(job);
}

void UnderWay::program_begins(int slot) {
  program_runs_ = true;
  hold_.nothing_runs_from_before();
  killed_at_ = {};  // the next prompt belongs to this run
  ProgramState& p = console_.snapshot.program;
  p.run = RunState::running;
  p.owned = true;
  p.slot = static_cast<std::int8_t>(slot >= 0 ? slot : slots_.selected());
  p.command = -1;
  p.command_reported = false;
  p.stepping = hold_.is_on();
  p.started_at = console_.scheduler.now();
  forget_how_it_ended();
  readings_.forget_directions();
  ended_run_.reset();
  console_.snapshot.working = false;
}

void UnderWay::forget_how_it_ended() {
  Snapshot& snapshot = console_.snapshot;
  snapshot.program.ended_by = EndedBy::nothing;
  for (int i = 0; i < snapshot.axis_count; ++i) snapshot.axes[i].ended_by = EndedBy::nothing;
}

// ---- end of a run

void UnderWay::run_ended(EndedBy ended_by) {
  if (job_.active()) {
    job_.ends_by(ended_by);
    job_.leg_is_over();
  }
  const bool was_running = std::exchange(program_runs_, false);
  if (!was_running) return;
  ProgramState& p = console_.snapshot.program;
  const bool unreported = p.ended_by == EndedBy::nothing;
  const bool was_stopped = ramp_.is_expected();
  if (was_stopped && ended_by == EndedBy::target && unreported)
    ended_by = EndedBy::stop;                              // its last index was cut
  if (was_stopped && hold_.is_on()) hold_.release_soon();  // the hold of its stop must not keep the next run
  ramp_.forget();
  hold_.nothing_runs_from_before();
  p.run = RunState::idle;
  if (ended_by != EndedBy::target) p.ended_by = ended_by;
  if (ended_by == EndedBy::target) {
    ended_run_ = p.slot;
    console_.snapshot.working = true;  // until the limits have shown how it ended
  }
  p.owned = false;
  p.stepping = false;
  p.command = -1;
  p.command_reported = false;
  p.slot = static_cast<std::int8_t>(slots_.selected());
  for (int i = 0; i < console_.snapshot.axis_count; ++i) {
    AxisState& axis = console_.snapshot.axes[i];
    const bool turned = axis.activity != Activity::idle && axis.activity != Activity::unknown;
    if (turned && ended_by != EndedBy::target) axis.ended_by = ended_by;
    if (turned) axis.activity = Activity::idle;
    axis.direction = 0;
  }
}

void UnderWay::killed(EndedBy ended_by) {
  kill_was_sent();
  presence_.note_answers_again();
  hold_.ended();
  ramp_.forget();
  if (job_.active()) {
    job_.drop_rest();
    job_.ends_by(EndedBy::abort);
    job_.leg_is_over();
  }
  if (program_runs_) run_ended(ended_by);
  Snapshot& snapshot = console_.snapshot;
  snapshot.program.run = RunState::idle;
  for (int i = 0; i < snapshot.axis_count; ++i)
    if (snapshot.axes[i].activity == Activity::error) snapshot.axes[i].activity = Activity::idle;
  news_.notify();
}

void UnderWay::kill_not_confirmed(EndedBy ended_by) {
  if (hold_.is_on()) hold_.doubt();
  if (job_.active() && !job_.is_leg_over()) job_.ends_by(ended_by);
  if (program_runs_) console_.snapshot.program.ended_by = ended_by;
}

void UnderWay::forget() {
  lost_while_busy_ = false;
  presence_.reset_is_over();
  job_ = Job();
  program_runs_ = false;
  console_.snapshot.program.run = RunState::idle;
  console_.snapshot.program.owned = false;
  ramp_.forget();
}

void UnderWay::wire_lost() {
  Snapshot& snapshot = console_.snapshot;
  lost_while_busy_ = lost_while_busy_ || busy();
  if (std::exchange(ended_run_, std::nullopt) && snapshot.program.ended_by == EndedBy::nothing)
    snapshot.program.ended_by = EndedBy::lost;
  snapshot.working = false;
  ramp_.forget();
  hold_.wire_lost();
  job_.drop_rest();  // no further leg begins by itself
  for (int i = 0; i < snapshot.axis_count; ++i) {
    AxisState& axis = snapshot.axes[i];
    if (axis.activity == Activity::error) axis.ended_by = EndedBy::lost;
    lose_motion(axis);
    axis.position_known = false;
    axis.limits_known = false;
  }
  snapshot.inputs_known = snapshot.outputs_known = snapshot.analog_known = 0;
  news_.notify();
}

}  // namespace hw::vxm
