#pragma once
// Estimates the output of a servo loop for a controller that does not report it, from command and encoder by
// the law of servo.h. Not a measurement: the loop is updated several times between two looks, of which only
// the mean change is seen. A KI sum from before the first look, and fractions of gains that the controller
// hides, are missing.
#include <cstdint>

#include "core/motion/servo.h"
#include "core/time/clock.h"

namespace hw::motion {

class ServoWatch {
 public:
  /// Resets: the next look() is the first.
  void start() { *this = ServoWatch(); }
  /// `speed`: commanded, counts/s, without sign. Returns steps of the converter, within +-output_limit.
  double look(const ServoGains& gains, Duration update_period, Instant at, std::int64_t command,
              std::int64_t encoder, double speed);

 private:
  bool fresh_ = true;
  Instant at_{};
  std::int64_t command_ = 0, error_ = 0;
  double speed_ = 0;  ///< counts/update, signed
  int way_ = 1;
  double sum_ = 0;
};

}  // namespace hw::motion
