#include "gui/model/axis_look.h"

namespace hw::gui {

int badness(State state) {
  switch (state) {
    case State::idle:
    case State::in_place: return 0;
    case State::off:
    case State::open_loop: return 1;
    case State::limit_plus:
    case State::limit_minus:
    case State::slipped:
    case State::not_in_place: return 2;
    case State::waiting: return 3;
    case State::moving_plus:
    case State::moving_minus:
    case State::moving:
    case State::homing_plus:
    case State::homing_minus:
    case State::stopping: return 4;
    case State::connecting: return 5;
    case State::stale:
    case State::untrusted: return 6;
    case State::fault: return 7;
    case State::lost: return 8;
  }
  return 0;
}

bool is_motion(State state) { return badness(state) == 4; }

bool is_old(const Snapshot& now, int axis, Instant clock) {
  return is_stale(now.axes[static_cast<std::size_t>(axis)].seen_at, clock, now.poll_period);
}

// A zero speed alone is no proof: the speed of a slow move is rounded to 0, and the first answers of a new
// move may hold none yet.
bool only_goes_along(const AxisState& a) {
  if (a.activity != Activity::moving || a.speed.value != 0 || a.phase == Phase::unknown) return false;
  return a.has_target && a.target == a.position;
}

State state_of(const Snapshot& now, int axis, Instant clock) {
  const AxisState& a = now.axes[static_cast<std::size_t>(axis)];
  if (now.link.state == LinkState::lost || now.link.state == LinkState::closed) return State::lost;
  if (now.link.state == LinkState::connecting || a.activity == Activity::unknown) return State::connecting;
  if (a.alarm || a.activity == Activity::error) return State::fault;
  if (is_old(now, axis, clock)) return State::stale;
  if (only_goes_along(a)) return State::waiting;
  switch (a.activity) {
    case Activity::moving:
    case Activity::jogging:
      return a.direction > 0 ? State::moving_plus : a.direction < 0 ? State::moving_minus : State::moving;
    case Activity::homing: return a.direction < 0 ? State::homing_minus : State::homing_plus;
    case Activity::stopping: return State::stopping;
    default: break;
  }
  if (a.slipped) return State::slipped;
  if (a.loop == Loop::open) return State::open_loop;
  if (!a.enabled) return State::off;
  if (a.limits_known && a.limit_plus) return State::limit_plus;
  if (a.limits_known && a.limit_minus) return State::limit_minus;
  if (a.loop == Loop::off_place) return State::not_in_place;
  return a.loop == Loop::in_place ? State::in_place : State::idle;
}

bool needs_attention(const Snapshot& now) {
  if (!now.notice.empty()) return true;
  for (const ThreadState& thread : now.threads)
    if (thread.known && thread.run == RunState::error) return true;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& a = now.axes[static_cast<std::size_t>(i)];
    const bool rests = a.activity == Activity::idle;
    const bool at_limit = rests && a.limits_known && (a.limit_minus || a.limit_plus);
    const bool lost = a.activity != Activity::homing && (!a.position_known || a.trust.doubtful());
    if (lost || a.slipped || a.loop == Loop::off_place || a.loop == Loop::open || at_limit) return true;
  }
  return false;
}

State worst_state(const Snapshot& now, Instant clock) {
  if (now.link.state == LinkState::lost || now.link.state == LinkState::closed) return State::lost;
  State worst = now.link.state == LinkState::late ? State::stale : State::idle;
  if (now.program.run == RunState::error) worst = State::fault;
  for (int i = 0; i < now.axis_count; ++i) {
    const State state = state_of(now, i, clock);
    if (is_motion(state) && is_motion(worst) && state != worst)
      worst = State::moving;
    else if (badness(state) > badness(worst))
      worst = state;
  }
  const ProgramState& program = now.program;
  const bool runs = program.run == RunState::running ||  // without motion: it waits for a time or an input
                    (program.owned && (program.run == RunState::waiting || program.run == RunState::held));
  if (runs && badness(worst) < badness(State::waiting)) worst = State::waiting;
  for (const ThreadState& thread : now.threads)  // a moving axis takes precedence
    if (thread.known && thread.run == RunState::error && !is_motion(worst) &&
        badness(worst) < badness(State::fault))
      worst = State::fault;
  return worst;
}

}  // namespace hw::gui
