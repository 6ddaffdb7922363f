#include "core/devices/vxm/ramp.h"

#include <algorithm>
#include <utility>

#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

// From the highest speed at acceleration 1: no ramp takes longer.
constexpr Duration longest_ramp = from_seconds(max_speed / (accel_unit * min_accel));
constexpr Duration to_see_a_ramp = Millis(300);

}  // namespace

void Ramp::expect() {
  if (!state_) state_ = State{console_.scheduler.now(), readings_.fastest()};
  state_->looked_at = console_.scheduler.now();
  state_->speed = readings_.fastest();
}

// If the motors do not slow down, D was lost. A motor that still turns after the longest ramp is killed.
StopProgress Ramp::watch() {
  constexpr double least_loss = min_accel * accel_unit * seconds(to_see_a_ramp) / 2;
  const Instant now = console_.scheduler.now();
  if (!state_) return StopProgress::again();
  if (now - state_->began > longest_ramp + to_see_a_ramp) return StopProgress::at_once();
  state_->speed = std::max(state_->speed, readings_.fastest());  // the motion may not have been seen before
  if (now - state_->looked_at < to_see_a_ramp) return StopProgress::wait();
  const double before = std::exchange(state_->speed, readings_.fastest());
  state_->looked_at = now;
  return state_->speed > before - least_loss ? StopProgress::again() : StopProgress::wait();
}

// ---- stop of a program

void Ramp::expect_of_program() {
  if (state_) return;
  state_ = State{console_.scheduler.now(), readings_.fastest(), hold_.is_on() || seems_to_stand()};
  hold_.expect_nothing_to_begin();
}

bool Ramp::must_be_seen_first() const {
  return !hold_.is_known() && !some_are_hidden() && readings_.fastest() <= 0;
}

void Ramp::was_held() {
  if (state_) state_->holds = true;
  hold_.expect_nothing_to_begin();
}

void Ramp::saw_one_turn_round(Instant since) {
  constexpr Duration shown_by_then = Millis(150);  // for motions begun before the hold
  if (state_ && since - state_->began > shown_by_then) state_->reversed = true;
}

// The stop is over when the program is held before a command, or when nothing has turned since D: a motor
// that takes no step in that time has practically no ramp.
StopProgress Ramp::watch_program() {
  if (!state_) return StopProgress::again();
  if (console_.snapshot.program.run == RunState::held || stands_since()) {
    state_->over = true;
    return StopProgress::again();  // the second stop is K
  }
  const StopProgress progress = watch();
  if (!goes_on(progress)) return progress;
  state_->holds = state_->reversed = false;
  state_->from = state_->slowest = readings_.fastest();
  return StopProgress::again();
}

// Where no hold is known to be on, a motion that begins shows that none is. So does a D without effect,
// unless all motors seem to stand, as in a held program.
bool Ramp::goes_on(const StopProgress& progress) {
  if (hold_.is_surely_on()) return state_->reversed || has_begun_anew();
  if (hold_.something_has_begun()) return true;
  const bool stands_as_held = hold_.is_on() && readings_.fastest() <= 0;
  return !hold_.is_known() && !stands_as_held && progress.now == StopProgress::Now::again;
}

// A motor slowed down and turns faster again: the next command has begun, so no hold is on.
bool Ramp::has_begun_anew() {
  constexpr double for_sure = 500;  // steps/s; twice the uncertainty of two successive readings
  if (readings_.fastest() > state_->from) state_->from = state_->slowest = readings_.fastest();
  state_->slowest = std::min(state_->slowest, readings_.fastest());
  return state_->slowest < state_->from - for_sure && readings_.fastest() > state_->slowest + for_sure;
}

bool Ramp::stands_since() const {
  const Instant now = console_.scheduler.now();
  const int motors = std::min(console_.snapshot.axis_count, motors_per_controller);
  for (int i = 0; i < motors; ++i)
    if (!readings_.has_stood_since(state_->began, i)) return false;
  return !some_are_hidden() || now - state_->began >= longest_ramp;
}

/// Whether all motors stand, as far as the last readings show.
bool Ramp::seems_to_stand() const {
  const Snapshot& snapshot = console_.snapshot;
  const int motors = std::min(snapshot.axis_count, motors_per_controller);
  for (int i = 0; i < motors; ++i) {
    if (!snapshot.axes[i].position_known || !readings_.has_stood_since(snapshot.program.started_at, i))
      return false;
  }
  return !some_are_hidden();
}

/// Motors 3 and 4 cannot be read while something runs, nor whether they exist: that is known once the
/// controller has been at rest.
bool Ramp::some_are_hidden() const {
  return identification_.has_slave() ||
         (!identification_.is_read() && console_.snapshot.axis_count > motors_per_controller);
}

}  // namespace hw::vxm
