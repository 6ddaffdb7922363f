// Hands on the jog buttons, on a joystick, on Run (Jog Mode p.7, App. H and J).
#include <algorithm>
#include <cstdlib>

#include "core/base/index.h"
#include "core/devices/vxm/emulator_box.h"

namespace hw::vxm {
namespace {

constexpr int joystick_unit = 250;  // steps/s at full deflection for range 1

bool jogging_waits(int u) { return u == 0 || u == 1 || u == 30 || u == 31 || u == 50 || u == 51 || u == 90; }

}  // namespace

bool Box::jog_allowed() const {
  if (!supply_.works() || state_.error != 0) return false;
  if (is_slave_) return !run_.on && rules_.jogs;
  if (!run_.on) return !host_.mode.online;
  return state_.jog_in_waits && run_.doing == Doing::waiting && jogging_waits(run_.wait.u);
}

int Box::jog_speed(int axis) const {
  const Setup& s = memory_.setup;
  const int most = line(line_in_2).low ? s.jog_2[ix(axis)] : s.jog_1[ix(axis)];
  return line(line_in_4).low ? std::min(most, jog_crawl) : most;
}

bool Box::wants_jog(int axis, Sign sign) const {
  if (memory_.setup.jog_1[ix(axis)] == 0) return false;  // setjmM0 switches the buttons off
  return line(line_jog + 2 * axis + (sign == Sign::plus ? 1 : 0)).low;
}

/// The stick moves motor 1, with input 3 low motor 2.
int Box::joystick_axis() const { return line(line_in_3).low ? 1 : 0; }

/// Signed; 0 inside the dead zone or when the range is 0. Range x goes from x to 250 x steps/s.
int Box::joystick_speed(int axis) const {
  const Setup& s = memory_.setup;
  const int range = line(line_in_2).low ? s.joy_2[ix(axis)] : s.joy_1[ix(axis)];
  const int deflection = terminals_.analog.deflection();
  const int beyond = std::abs(deflection) - s.dead_zone;
  if (range == 0 || beyond <= 0) return 0;
  const int full = std::max(analog_max / 2 - s.dead_zone, 1);
  const int speed = range + (joystick_unit * range - range) * std::min(beyond, full) / full;
  return deflection < 0 ? -speed : speed;
}

bool Box::update_jog() {
  using Phase = Jog::Phase;
  const bool mine = motion_.kind == MotionKind::jog || motion_.kind == MotionKind::joystick;
  if ((jog_.phase == Phase::turning || jog_.phase == Phase::ending) && !(mine && motion_.active)) {
    jog_.phase = mine && motion_.end == MotionEnd::limit ? Phase::blocked : Phase::none;
    if (mine) motion_.ended = false;
    return true;
  }
  const bool allowed = jog_allowed();
  if (jog_.phase == Phase::none) {
    if (!allowed || motion_.active) return false;
    jog_start();
    return jog_.phase != Phase::none;
  }
  const int stick = jog_.joystick ? joystick_speed(jog_.axis) : 0;
  const bool same_way =
      jog_.joystick ? stick != 0 && (stick > 0) == (jog_.sign == Sign::plus) && jog_.axis == joystick_axis()
                    : wants_jog(jog_.axis, jog_.sign);
  if (!allowed || !same_way) {
    if (jog_.phase == Phase::ending) return false;
    if (jog_.phase == Phase::turning) return jog_end(), true;
    jog_.phase = Phase::none;
    return true;
  }
  const int speed = jog_.joystick ? std::abs(stick) : jog_speed(jog_.axis);
  if (jog_.phase == Phase::stepped && now_ >= jog_.since + jog_delay) {
    jog_turn(jog_.axis, jog_.sign, speed, false);
    return true;
  }
  if (jog_.phase == Phase::turning && speed != jog_.speed) {
    jog_.speed = speed;
    motion_.profile =
        motion::Profile::change(now_, motion_.profile.distance(now_), motion_.profile.speed(now_), Pps(speed),
                                ramp(jog_.axis), motion::Profile::endless);
    return true;
  }
  return false;
}

void Box::jog_start() {
  for (int axis = 0; axis < motors_per_controller; ++axis) {
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      if (!wants_jog(axis, sign)) continue;
      jog_ = Jog();
      jog_.phase = Jog::Phase::stepped;
      jog_.axis = axis, jog_.sign = sign, jog_.since = now_;
      host_.entry.motor = axis + 1;
      const auto free = turns_until_stop(axis, sign, false);
      if (free && *free == 0) {
        jog_.phase = Jog::Phase::blocked;
        return;
      }
      note_pulses(axis, sign, 1);
      apply_turn(axis, sign, 1);
      return;
    }
  }
  const int axis = joystick_axis(), stick = joystick_speed(axis);
  if (stick != 0) jog_turn(axis, stick < 0 ? Sign::minus : Sign::plus, std::abs(stick), true);
}

void Box::jog_turn(int axis, Sign sign, int speed, bool joystick) {
  jog_.phase = Jog::Phase::turning;
  jog_.axis = axis, jog_.sign = sign, jog_.speed = speed, jog_.joystick = joystick;
  host_.entry.motor = axis + 1;
  const auto profile =
      motion::Profile::change(now_, 0, Pps(0), Pps(speed), ramp(axis), motion::Profile::endless);
  if (!start_motion(joystick ? MotionKind::joystick : MotionKind::jog, axis, sign, profile)) {
    motion_.ended = false;
    jog_.phase = Jog::Phase::blocked;
  }
}

void Box::jog_end() {
  jog_.phase = Jog::Phase::ending;
  decelerate();
}

std::optional<Instant> Box::jog_event() const {
  if (jog_.phase != Jog::Phase::stepped) return std::nullopt;
  return jog_.since + jog_delay;
}

/// Run, pressed for the valid time while nothing runs, starts a program (App. B, C).
std::optional<Instant> Box::run_button_event() const {
  const Line& button = line(line_run);
  if (!button.low || button.used || is_slave_ || !supply_.works()) return std::nullopt;
  return button.since + valid_time();
}

bool Box::run_button_if_due() {
  const auto due = run_button_event();
  if (!due || *due > now_) return false;
  terminals_.lines[ix(line_run)].used = true;
  if (run_.on || state_.error != 0 || (memory_.setup.inputs & inputs_run) == 0) return true;
  int program = host_.entry.program;
  if (memory_.setup.inputs & inputs_select)
    program = (line(line_in_2).low ? 1 : 0) + (line(line_in_3).low ? 2 : 0);
  start_run(program);
  return true;
}

}  // namespace hw::vxm
