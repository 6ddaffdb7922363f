#include "core/motion/profile.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace hw;
using namespace hw::motion;

namespace {

Instant at(double s) { return Instant(from_seconds(s)); }
double when(Instant t) { return seconds(t); }

TEST(Profile, TrapezoidTakesTheTimeOfTheFormula) {
  // 2000 steps/s at 2000 steps/s²: 1 s and 1000 steps up, 1 s and 1000 steps down.
  const Profile p = Profile::index(at(5), 6000, Pps(2000), Ramp(2000, 2000));
  EXPECT_NEAR(when(p.end()), 5 + 1 + 2 + 1, 1e-8);
  EXPECT_NEAR(p.speed(at(7)).value, 2000, 1e-6);
  EXPECT_EQ(p.steps(at(6)), 1000);
  EXPECT_NEAR(when(p.time_at(1000)), 6, 1e-8);
  EXPECT_NEAR(when(p.time_at(3000)), 7, 1e-8);
  ASSERT_TRUE(p.slows_at());
  EXPECT_EQ(p.steps(*p.slows_at()), 5000);
  EXPECT_EQ(p.steps(p.end()), 6000);
  EXPECT_EQ(p.steps(p.end() - Duration(1)), 5999);
}

TEST(Profile, ShortWayIsATriangle) {
  const Profile p = Profile::index(at(0), 400, Pps(2000), Ramp(2000, 2000));
  const double peak = std::sqrt(2000.0 * 400);
  EXPECT_NEAR(when(p.end()), 2 * peak / 2000, 1e-8);
  EXPECT_EQ(p.steps(*p.slows_at()), 200);
}

TEST(Profile, RampsMayDifferAndStartAboveZero) {
  const Profile p = Profile::index(at(0), 10000, Pps(2000), Ramp(1000, 4000, Pps(500)));
  const double up = (2000.0 * 2000 - 500 * 500) / 2000, down = (2000.0 * 2000 - 500 * 500) / 8000;
  const double time = 1.5 + (10000 - up - down) / 2000 + 1500 / 4000.0;
  EXPECT_NEAR(when(p.end()), time, 1e-8);
  EXPECT_NEAR(p.speed(at(0)).value, 500, 1e-9);
}

TEST(Profile, StepsAndTheirTimesAgreeEverywhere) {
  for (const std::int64_t length : {1, 2, 3, 7, 400, 8001}) {
    for (const double slew : {1.0, 39.0, 800.0, 6000.0}) {
      const Profile p = Profile::index(at(3.3), length, Pps(slew), Ramp(2000, 127000));
      Instant before = p.start();
      for (std::int64_t k = 1; k <= length; ++k) {
        const Instant t = p.time_at(k);
        ASSERT_LE(before, t);
        ASSERT_EQ(p.steps(t), k) << length << " at " << slew;
        ASSERT_EQ(p.steps(t - Duration(1)), k - 1) << length << " at " << slew;
        before = t;
      }
      EXPECT_EQ(p.end(), before);
    }
  }
}

TEST(Profile, StopFromTheMiddleEndsOnAWholeStep) {
  const Profile p = Profile::index(at(0), 100000, Pps(2000), Ramp(2000, 2000));
  const Instant t = at(4.0001);
  const Profile q = Profile::stop(t, p.distance(t), p.speed(t), 2000);
  EXPECT_EQ(q.length(), std::llround(p.distance(t) + 1000));
  EXPECT_EQ(q.steps(t), p.steps(t));
  EXPECT_NEAR(when(q.end()) - when(t), 1.0, 1e-3);
  EXPECT_EQ(q.steps(q.end()), q.length());
}

TEST(Profile, StopBeforeTheFirstStepMakesNone) {
  const Profile p = Profile::index(at(0), 100, Pps(2000), Ramp(2000, 2000));
  const Instant t = at(0.001);
  const Profile q = Profile::stop(t, p.distance(t), p.speed(t), 2000);
  EXPECT_EQ(q.length(), 0);
  EXPECT_EQ(q.end(), t);
}

TEST(Profile, ChainKeepsItsSpeedFromBlockToBlock) {
  const Ramp ramp(2000, 2000);
  const Profile one = Profile::change(at(0), 0, Pps(0), Pps(1500), ramp, 1000);
  EXPECT_NEAR(one.final_speed().value, 1500, 1e-9);
  const Profile two = Profile::change(one.end(), 0, one.final_speed(), Pps(500), ramp, 2000);
  EXPECT_NEAR(two.speed(two.end() - Duration(1)).value, 500, 1e-6);
  const Profile end = Profile::stop(two.end(), 0, two.final_speed(), 2000);
  EXPECT_EQ(end.length(), 63);  // 500² / 4000 = 62.5
  const Profile exact = Profile::stop_within(two.end(), 0, two.final_speed(), 100);
  EXPECT_EQ(exact.length(), 100);
  EXPECT_NEAR(when(exact.end()) - when(two.end()), 2 * 100 / 500.0, 1e-8);
}

TEST(Profile, BlockTooShortForTheSpeedChangeGoesOnWithWhatItReached) {
  const Profile p = Profile::change(at(0), 0, Pps(0), Pps(6000), Ramp(2000, 2000), 100);
  EXPECT_NEAR(p.final_speed().value, std::sqrt(2 * 2000.0 * 100), 1e-6);
  EXPECT_EQ(p.steps(p.end()), 100);
  EXPECT_FALSE(p.slows_at());
}

TEST(Profile, EndlessMoveStaysDefined) {
  const Profile p = Profile::change(at(1), 0, Pps(0), Pps(1), Ramp(1, 1), Profile::endless);
  EXPECT_EQ(p.steps(at(1001)), 999);
  EXPECT_GT(p.end(), at(1e9));
}

}  // namespace
