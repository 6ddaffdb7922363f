#pragma once
// Table A.0 and the rules around it: which ramps a speed allows, and which ramps a positional move gets
// (appendix A of both manuals; decisions AMB-047 to AMB-057).
#include <cstdint>

#include "core/devices/arcus/facts.h"
#include "core/motion/profile.h"

namespace hw::arcus {

/// Speeds and ramps ordered for a move, in the unit of the commands (pulses or counts per second).
struct SpeedOrder {
  std::int64_t high = 1, low = 1, accel_ms = 1, decel_ms = 1;  ///< as written
  double ratio = 1;  ///< pulses per unit: the ratio of StepNLoop, or 1
  motion::RampShape shape = motion::RampShape::linear;
};

const SpeedRow& speed_row(const Model& model, double pulses_per_second);

/// `written` as the controller adjusts it, reads it back and uses it.
std::int64_t adjusted_ms(const Model& model, const SpeedOrder& order, std::int64_t written);

/// Speeds and slopes in pulses.
struct RampOrder {
  Pps top;
  motion::Ramp ramp;
};
/// For moves without a fixed end.
RampOrder ramps(const Model& model, const SpeedOrder& order);
/// For a positional move over `pulses`: the three rules of figure A.1.
RampOrder ramps_over(const Model& model, const SpeedOrder& order, double pulses);

}  // namespace hw::arcus
