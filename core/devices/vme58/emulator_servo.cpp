// Servo axes. Without a motor on the bench the load follows the command exactly while the loop is closed
// (decision M77). With a motor the sampled loop moves the load: one update per servo period, on one grid for
// all axes, none while every loop is at rest.
#include <cmath>

#include "core/devices/vme58/emulator_motion.h"

namespace hw::vme58 {
namespace {

motion::ServoGains loop_gains(const Gains& g) {
  motion::ServoGains gains;
  gains.kp = g.proportional, gains.ki = g.integral, gains.kd = g.differential;
  gains.kv = g.velocity_feed_forward, gains.ka = g.acceleration_feed_forward, gains.ko = g.offset;
  gains.kn = g.integration_exponent;
  return gains;
}

}  // namespace

void Motion::changed(int a) {
  bring_up_to_date();
  MotionAxis& x = axes_[ix(a)];
  if (x.servo()) {
    x.loop.gains = loop_gains(x.settings.gains);
    x.loop.wake();
    if (x.settings.holding != x.was_holding) switch_servo(a);
  }
  x.was_holding = x.settings.holding;
  replan(a);
  schedule_updates();
}

/// HN and HF. A closing loop takes the shaft position as its command, so nothing jumps.
void Motion::switch_servo(int a) {
  MotionAxis& x = axes_[ix(a)];
  if (Run* r = run_of(a); r != nullptr && x.off()) finish(*r, End::cut);
  if (x.settings.holding) x.set_position(x.encoder());
  x.loop.close(x.settings.holding);
}

/// The command between two counts, as the feedforward needs it.
double Motion::exact_command(int a) const {
  const MotionAxis& x = axes_[ix(a)];
  const Run* r = run_of(a);
  const auto here = static_cast<double>(x.position);
  if (r == nullptr) return here;
  return here - static_cast<double>(r->track.offset(ix(a), r->applied)) +
         r->track.exact(ix(a), r->profile.distance(now_));
}

bool Motion::at_work(int a) const {
  const MotionAxis& x = axes_[ix(a)];
  return x.has_motor && x.loop.closed() && !x.loop.at_rest();
}

std::int64_t Motion::sampled_position(int a) const {
  const MotionAxis& x = axes_[ix(a)];
  return at_work(a) ? x.encoder() + x.loop.error() : x.position;
}

double Motion::sampled_velocity(int a) const {
  if (!at_work(a)) return velocity(a);
  return std::abs(axes_[ix(a)].loop.command_speed()) / seconds(board_.servo_period);
}

void Motion::update_servo(int a) {
  MotionAxis& x = axes_[ix(a)];
  const std::int64_t before = x.loop.plant.counts();
  x.loop.tick(exact_command(a) - static_cast<double>(x.zero), seconds(board_.servo_period));
  const std::int64_t made = x.loop.plant.counts() - before;
  if (made != 0) {
    const Sign way = made < 0 ? Sign::minus : Sign::plus;
    const auto to_index = x.counts_until_index(way);
    x.index_passed = to_index && *to_index <= std::abs(made);
    x.plant.turn(way, std::abs(made));
  } else {
    x.index_passed = false;
  }
  if (Run* r = run_of(a))
    look(*r);
  else
    watch_error(a);
}

void Motion::update_servos() {
  update_at_ = *update_at_ + board_.servo_period;
  bool awake = false;
  for (int a = 0; a < most_axes; ++a) {
    MotionAxis& x = axes_[ix(a)];
    if (!x.has_motor || (x.run < 0 && x.loop.at_rest())) continue;
    update_servo(a);
    awake = awake || x.run >= 0 || !x.loop.at_rest();
  }
  if (!awake) update_at_.reset();
}

void Motion::schedule_updates() {
  if (update_at_) return;
  for (const MotionAxis& x : axes_) {
    if (!x.has_motor || (x.run < 0 && x.loop.at_rest())) continue;
    const Duration period = board_.servo_period, since = now_.time_since_epoch();
    update_at_ = Instant((since / period + 1) * period);
    return;
  }
}

}  // namespace hw::vme58
