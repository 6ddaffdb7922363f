#include "core/motion/servo_watch.h"

#include <algorithm>
#include <cmath>

namespace hw::motion {

double ServoWatch::look(const ServoGains& gains, Duration update_period, Instant at, std::int64_t command,
                        std::int64_t encoder, double speed) {
  const std::int64_t error = command - encoder;
  ServoTerms terms;
  terms.error = static_cast<double>(error);
  if (!fresh_ && command != command_) way_ = command > command_ ? 1 : -1;
  terms.speed = way_ * speed * seconds(update_period);
  if (!fresh_ && at > at_) {
    const double updates = seconds(at - at_) / seconds(update_period);
    terms.change = static_cast<double>(error - error_) / updates;
    terms.acceleration = (terms.speed - speed_) / updates;
    sum_ = bounded_sum(gains, sum_ + terms.error * updates / std::exp2(std::clamp(gains.kn, 0, 15)));
  }
  terms.sum = sum_;
  fresh_ = false;
  at_ = at, command_ = command, error_ = error, speed_ = terms.speed;
  return std::clamp<double>(servo_output(gains, terms), -output_limit, output_limit);
}

}  // namespace hw::motion
