#pragma once
// Settings of an axis, and of the board as a whole. The firmware writes them when a command takes effect; the
// motion (emulator_motion.h) reads them when a motion begins, a switch is met or a servo is sampled.
#include <array>
#include <cstdint>

#include "core/devices/vme58/facts.h"
#include "core/time/clock.h"

namespace hw::vme58 {

/// KP KI KD KV KA KO KN. Not negative (decision M77), except KO.
struct Gains {
  double proportional = 0, integral = 0, differential = 0;
  double velocity_feed_forward = 0, acceleration_feed_forward = 0, offset = 0;
  int integration_exponent = 0;  ///< integrates over 2^n updates
};

struct AxisSettings {
  // Speeds and ramps: AC VL VB, in counts.
  double acceleration = default_acceleration, velocity = default_velocity, base_velocity = 0;

  // Switches: HH HL, HE HS, LF LN, SL SF.
  bool home_active_high = false;
  bool home_needs_index = false;
  bool limits_on = true;
  bool soft_limits = false;

  // Encoder: HN HF, ER, HV, HG, HD, ES, TN TF, IS, ET.
  /// Servo: the loop is closed. It is closed at power-up, so that software that never tunes can still move
  /// (decision M77). Step axis: position maintenance is on.
  bool holding = false;
  double encoder_counts_per_ratio = 1, motor_counts_per_ratio = 1;
  double hold_velocity = 0, hold_gain = 0;
  std::int64_t hold_deadband = 0, slip_tolerance = 0;  ///< a tolerance of 0: no slip detection
  bool slip_kills = false;
  bool slip_interrupts = false;
  bool tracking = false;

  Gains gains;

  // Outputs: PA SE (done by the firmware), PI BI UN (kept, without effect: decision M46).
  bool power_automatic = false;
  Duration settling{};
  double pwm_period = 0;
  bool bipolar = true;

  /// UU: counts of a user unit; 0: off. The firmware multiplies operands before anything else uses them.
  double user_unit = 0;
};

enum class RampForm : std::uint8_t { linear, cosine, parabolic };

/// CN PN PF: the latest of them applies, to all axes (decision M45).
struct BoardSettings {
  RampForm ramp = RampForm::linear;
  int truncation = 0;                                    ///< PN's operand, 1..10
  double contour_velocity = 0;                           ///< CV; 0: not set yet
  Duration servo_period = std::chrono::milliseconds(1);  ///< decision M96
};

}  // namespace hw::vme58
