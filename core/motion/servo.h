#pragma once
// A servo axis in fixed ticks: a sampled PID that drives a motor through an analog output. It is the only
// simulation with time steps; between two ticks the output is held and the motor moves in closed form.
//
//   error  = command - encoder                                      counts
//   sum   += error, once in 2^KN updates, as long as the output can follow
//   output = KP error + 8 KD change(error) + KI sum / 256           steps of the converter, 0x800 = 10 V
//          + 8 KV speed + 64 KA acceleration + KO                   counts/update, counts/update²
//
// servo_output() is this law, for the loop here and for the console's estimate of the output of a board that
// does not report it (servo_watch.h).
//
// The scale makes the data sheet's example (KP2 KD6, first example) a quiet loop for the motor of `Motor()`,
// with an update each millisecond. That motor gains 6,200 counts/s² for each step of the converter, loses its
// speed in 0.1 s when left alone, and sticks below 4 steps. Response to a jump of the command by 200 or 1000
// counts (tests/core/motion/servo_test.cpp):
//
//   KP2 KD6       no overshoot, within 2% after 0.1 s, stands up to 2 counts off: dry friction holds it
//   KP4 KD6 KI4   under 5% overshoot, crossed once, and the sum pulls in the last counts within seconds
//   KP2 KD0       rings: 93% overshoot, the target is crossed twenty times in half a second
//   KV0.2 KA2.5   with KP2 KD6: takes two thirds and more of the error out of a move
//   KP20 KD6      25 to 50% overshoot, crossed four times and more: the gain is too high for the update
#include <cstdint>

#include "core/base/units.h"
#include "core/motion/motor.h"
#include "core/time/clock.h"

namespace hw::motion {

/// As the commands KP KI KD KV KA KO KN set them. Only KN is bounded: 0 to 15.
struct ServoGains {
  double kp = 0, ki = 0, kd = 0, kv = 0, ka = 0, ko = 0;
  int kn = 0;
  bool operator==(const ServoGains&) const = default;
};

inline constexpr double output_steps_per_volt = 204.8;  ///< 12 bits over +-10 V
inline constexpr int output_limit = 2047;

/// Inputs of one update of the loop, in counts and updates.
struct ServoTerms {
  double error = 0, change = 0, sum = 0;
  double speed = 0, acceleration = 0;  ///< of the command
};
/// Steps of the converter, before rounding and clamping to output_limit.
double servo_output(const ServoGains& gains, const ServoTerms& terms);
/// The sum, limited to what the output can follow.
double bounded_sum(const ServoGains& gains, double sum);

/// A motor with its load and amplifier, turning freely. State in counts of its encoder.
class MotorModel {
 public:
  MotorModel() { set(Motor()); }
  explicit MotorModel(const Motor& motor) { set(motor); }

  /// Takes effect at once; position and speed are kept.
  void set(const Motor& motor);
  [[nodiscard]] const Motor& motor() const { return motor_; }

  /// Turns the shaft for `s` seconds at `volts`. A jammed shaft does not move.
  void turn(double volts, double s);
  [[nodiscard]] std::int64_t counts() const;
  [[nodiscard]] double speed() const { return speed_; }    ///< counts/s, signed
  [[nodiscard]] double torque() const { return torque_; }  ///< Nm of the last turn
  [[nodiscard]] bool still_at(double volts) const;
  void put(double counts) { place_ = counts, speed_ = 0; }
  void shift(double counts) { place_ += counts; }
  void jam(bool on);

 private:
  void coast(double accel, double s);

  Motor motor_;
  double accel_per_nm_ = 1;  ///< counts/s² for each Nm
  double decay_ = 0;         ///< 1/s, viscous
  double drag_ = 0;          ///< counts/s², dry friction
  double place_ = 0, speed_ = 0, torque_ = 0;
  bool jammed_ = false;
};

/// The loop of one axis. Copyable; the same calls give the same motion.
class ServoLoop {
 public:
  ServoGains gains;
  MotorModel plant;

  /// Closed: the error decides; open: the output is 0 and the shaft is free.
  void close(bool on);
  [[nodiscard]] bool closed() const { return closed_; }
  /// One update: turns the motor by the last output, samples encoder and command, and sets the new output.
  void tick(double command, double period_s);
  /// Further updates with the same command change nothing and may be skipped.
  [[nodiscard]] bool at_rest() const { return at_rest_; }
  /// Shifts the counts of command and shaft together.
  void shift(double counts);
  /// Call when something has changed that ends at_rest().
  void wake() { at_rest_ = false; }

  [[nodiscard]] std::int64_t error() const { return error_; }
  /// Of the command, in counts between the latest two updates.
  [[nodiscard]] double command_speed() const { return command_speed_; }
  [[nodiscard]] int output() const { return output_; }  ///< steps of the converter
  [[nodiscard]] double volts() const { return output_ / output_steps_per_volt; }

 private:
  [[nodiscard]] double filtered(std::int64_t change, double speed, double accel);

  bool closed_ = false, at_rest_ = false, fresh_ = true;
  std::int64_t error_ = 0;
  double sum_ = 0, command_ = 0, command_speed_ = 0;
  int updates_ = 0, output_ = 0;
};

}  // namespace hw::motion
