#include "core/motion/servo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hw::motion {
namespace {

constexpr double furthest = 1e15;  // counts; keeps conversion to integer defined
constexpr double slow = 1e-9;      // counts/s; below: at rest

constexpr double derivative_scale = 8, acceleration_scale = 64, integral_scale = 1.0 / 256;

}  // namespace

double servo_output(const ServoGains& g, const ServoTerms& t) {
  return g.kp * t.error + derivative_scale * g.kd * t.change + integral_scale * g.ki * t.sum +
         derivative_scale * g.kv * t.speed + acceleration_scale * g.ka * t.acceleration + g.ko;
}

double bounded_sum(const ServoGains& gains, double sum) {
  const double most = gains.ki > 0 ? output_limit / (gains.ki * integral_scale) : 0;
  return std::clamp(sum, -most, most);
}

void MotorModel::set(const Motor& motor) {
  motor_ = motor;
  accel_per_nm_ = motor.counts_per_turn / (2 * std::numbers::pi) / motor.inertia;
  decay_ = motor.viscous / motor.inertia;
  drag_ = motor.friction * accel_per_nm_;
}

std::int64_t MotorModel::counts() const { return static_cast<std::int64_t>(std::floor(place_)); }

void MotorModel::jam(bool on) {
  jammed_ = on;
  if (on) speed_ = 0;
}

bool MotorModel::still_at(double volts) const {
  const double torque = std::clamp(volts * motor_.torque_per_volt, -motor_.torque_limit, motor_.torque_limit);
  return jammed_ || (speed_ == 0 && std::abs(torque) <= motor_.friction);
}

/// v' = accel - decay v, over `s` seconds without a change of direction.
void MotorModel::coast(double accel, double s) {
  if (decay_ * s < 1e-9) {
    place_ += s * (speed_ + accel * s / 2);
    speed_ += accel * s;
    return;
  }
  const double final_speed = accel / decay_, gone = -std::expm1(-decay_ * s);
  place_ += final_speed * s + (speed_ - final_speed) * gone / decay_;
  speed_ += (final_speed - speed_) * gone;
}

void MotorModel::turn(double volts, double s) {
  torque_ = std::clamp(volts * motor_.torque_per_volt, -motor_.torque_limit, motor_.torque_limit);
  if (jammed_) return;
  const double push = torque_ * accel_per_nm_;
  // At most two parts: until it stands, and on from there.
  for (int part = 0; part < 2 && s > 0; ++part) {
    if (speed_ == 0 && std::abs(push) <= drag_) return;
    const double way = speed_ != 0 ? std::copysign(1.0, speed_) : std::copysign(1.0, push);
    const double accel = push - way * drag_;
    double until_rest = std::numeric_limits<double>::infinity();
    if (speed_ * accel < 0)
      until_rest = decay_ > 0 ? std::log1p(-speed_ * decay_ / accel) / decay_ : -speed_ / accel;
    const double lasts = std::min(s, until_rest);
    coast(accel, lasts);
    if (until_rest <= s || std::abs(speed_) < slow) speed_ = 0;
    s -= lasts;
  }
  place_ = std::clamp(place_, -furthest, furthest);
}

void ServoLoop::close(bool on) {
  if (on != closed_) fresh_ = true, sum_ = 0, updates_ = 0, output_ = 0, error_ = 0, command_speed_ = 0;
  closed_ = on;
  at_rest_ = false;
}

void ServoLoop::shift(double counts) {
  plant.shift(counts);
  command_ += counts;
}

double ServoLoop::filtered(std::int64_t change, double speed, double accel) {
  if (++updates_ >= 1 << std::clamp(gains.kn, 0, 15)) {
    updates_ = 0;
    sum_ = bounded_sum(gains, sum_ + static_cast<double>(error_));
  }
  ServoTerms terms;
  terms.error = static_cast<double>(error_), terms.change = static_cast<double>(change), terms.sum = sum_;
  terms.speed = speed, terms.acceleration = accel;
  return servo_output(gains, terms);
}

void ServoLoop::tick(double command, double period_s) {
  plant.turn(volts(), period_s);
  if (fresh_) command_ = command, command_speed_ = 0;
  const double speed = command - command_;
  const double accel = speed - command_speed_;
  const std::int64_t error = std::llround(command) - plant.counts();
  const std::int64_t change = fresh_ ? 0 : error - error_;
  fresh_ = false;
  command_ = command, command_speed_ = speed, error_ = error;
  double wanted = closed_ ? filtered(change, speed, accel) : 0;
  if (std::isnan(wanted)) wanted = 0;  // infinite gains of opposite sign
  const int before = output_;
  output_ = static_cast<int>(std::lround(std::clamp<double>(wanted, -output_limit, output_limit)));
  const bool summing = closed_ && gains.ki != 0 && error != 0;
  at_rest_ =
      speed == 0 && accel == 0 && change == 0 && output_ == before && !summing && plant.still_at(volts());
}

}  // namespace hw::motion
