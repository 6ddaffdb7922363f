#pragma once
#include <array>
#include <string_view>

namespace hw {

/// The bench's servo motor with amplifier and load. The amplifier turns the board's +-10 V into torque. The
/// defaults fit the example gains of the data sheet (core/motion/servo.h).
struct Motor {
  bool present = true;            ///< false: an ideal plant, always at the commanded position
  double inertia = 5e-5;          ///< kg m², load included
  double viscous = 5e-4;          ///< Nm s/rad
  double friction = 0.002;        ///< Nm, dry
  double torque_per_volt = 0.1;   ///< Nm/V
  double torque_limit = 1;        ///< Nm
  double counts_per_turn = 4000;  ///< of the encoder, quadrature included
  bool operator==(const Motor&) const = default;
};

/// Names and ranges of its values in a bench file and a script's bench:place().
struct MotorKey {
  std::string_view name;
  double Motor::*value;
  double low, high;
};
inline constexpr std::array<MotorKey, 6> motor_keys{{
    {"inertia", &Motor::inertia, 1e-9, 1e6},
    {"viscous", &Motor::viscous, 0, 1e6},
    {"friction", &Motor::friction, 0, 1e6},
    {"torque_per_volt", &Motor::torque_per_volt, -1e6, 1e6},
    {"torque_limit", &Motor::torque_limit, 0, 1e6},
    {"counts_per_turn", &Motor::counts_per_turn, 1, 1e9},
}};

}  // namespace hw
