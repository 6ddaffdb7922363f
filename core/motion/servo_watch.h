#pragma once
// The output of a servo loop worked out from outside, for a controller that does not tell it: looks at
// command and encoder, and puts what they say through the law of servo.h. It is no measurement. Between two
// looks the loop has been updated some times and only the mean change is seen; a KI sum from before the first
// look, and fractions of gains that the controller hides, are not in it.
#include <cstdint>

#include "core/motion/servo.h"
#include "core/time/clock.h"

namespace hw::motion {

class ServoWatch {
 public:
  /// The next look() is the first one.
  void start() { *this = ServoWatch(); }
  /// `speed`: commanded, counts/s, without sign. Gives steps of the converter, within +-output_limit.
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
