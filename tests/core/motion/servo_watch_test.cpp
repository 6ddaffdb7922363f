// The output of a loop as it can be worked out from outside, against the loop itself.
#include "core/motion/servo_watch.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hw::motion {
namespace {

constexpr Duration update = Millis(1);

struct Differences {
  double largest = 0, mean = 0;
};

/// A move with ramps, looked at after every `updates` updates of the loop.
Differences watched(const ServoGains& gains, int updates) {
  ServoLoop loop;
  loop.gains = gains;
  loop.close(true);
  ServoWatch watch;
  watch.start();
  Differences d;
  double command = 0, speed = 0;
  int looks = 0;
  for (int ms = 0; ms < 400; ++ms) {
    const double before = command;
    speed = ms < 40 ? ms * 0.5 : ms < 80 ? (80 - ms) * 0.5 : 0;  // counts/update
    command += speed;
    loop.tick(command, seconds(update));
    if (ms % updates != 0) continue;
    const auto at = std::llround(command);
    const double guess = watch.look(gains, update, Instant(Millis(ms)), at, at - loop.error(),
                                    std::abs(command - before) / seconds(update));
    const double off = std::abs(guess - loop.output());
    d.largest = std::max(d.largest, off);
    d.mean += off;
    ++looks;
  }
  d.mean /= looks;
  return d;
}

ServoGains all_gains() {
  ServoGains g;
  g.kp = 4, g.kd = 6, g.ki = 4, g.kv = 0.2, g.ka = 2.5, g.ko = 5;
  return g;
}

TEST(ServoWatch, ReadingEachUpdateGivesTheOutput) {
  EXPECT_LE(watched(all_gains(), 1).largest, 0.5) << "the converter's rounding";
}

TEST(ServoWatch, EachSecondUpdateGivesTheMean) {
  const Differences d = watched(all_gains(), 2);
  EXPECT_LT(d.largest, 0.08 * output_limit);
  EXPECT_LT(d.mean, 0.01 * output_limit);
  EXPECT_GT(d.largest, 0.5);
}

TEST(ServoWatch, TheIntegralIsTakenInItsInterval) {
  ServoGains g;
  g.ki = 256;  // a step of the converter for each count summed up
  g.kn = 3;
  ServoWatch watch;
  (void)watch.look(g, update, Instant(), 8, 0, 0);
  EXPECT_DOUBLE_EQ(watch.look(g, update, Instant(Millis(16)), 8, 0, 0), 16);
  EXPECT_DOUBLE_EQ(watch.look(g, update, Instant(std::chrono::hours(1)), 8, 0, 0), output_limit);
  watch.start();
  EXPECT_DOUBLE_EQ(watch.look(g, update, Instant(std::chrono::hours(2)), 8, 0, 0), 0) << "a new recording";
}

TEST(ServoWatch, SpeedFollowsTheWayOfTheCommand) {
  ServoGains g;
  g.kv = 10;
  ServoWatch watch;
  (void)watch.look(g, update, Instant(), 100, 100, 0);
  EXPECT_DOUBLE_EQ(watch.look(g, update, Instant(Millis(1)), 99, 99, 1000), -80);
  EXPECT_DOUBLE_EQ(watch.look(g, update, Instant(Millis(2)), 100, 100, 1000), 80);
}

}  // namespace
}  // namespace hw::motion
