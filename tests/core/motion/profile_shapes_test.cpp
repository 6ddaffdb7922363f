// What the profiles promise together, for S-curves and for changes under way: distance only grows, ends where
// it should, and step k is made at time_at(k).
#include <cmath>

#include <gtest/gtest.h>

#include "core/motion/profile.h"

namespace hw::motion {
namespace {

constexpr Instant start{std::chrono::seconds(3)};

void check(const Profile& p, std::int64_t first, std::int64_t length) {
  EXPECT_EQ(p.length(), length);
  double before = static_cast<double>(first);
  const double lasts = seconds(p.end() - p.start());
  ASSERT_GE(lasts, 0);
  for (int i = 0; i <= 1000; ++i) {
    const Instant t = p.start() + from_seconds(lasts * i / 1000);
    EXPECT_GE(p.distance(t), before - 1e-6);
    before = p.distance(t);
    EXPECT_GE(p.speed(t).value, 0);
  }
  for (std::int64_t k = first + 1; k <= length; k += 1 + (length - first) / 97) {
    const Instant t = p.time_at(k);
    EXPECT_GE(p.steps(t), k);
    if (t > p.start()) {
      EXPECT_LT(p.steps(t - Duration(2)), k) << "step " << k;
    }
  }
  EXPECT_EQ(p.steps(p.end()), length);
}

TEST(ProfileShapes, AnSCurveTakesTheTimeOfItsTrapezoid) {
  const Ramp straight(10'000, 5'000, Pps(100)), soft(10'000, 5'000, Pps(100), RampShape::s_curve);
  for (const std::int64_t length : {5, 100, 5'000, 100'000}) {
    const Profile a = Profile::index(start, length, Pps(4000), straight);
    const Profile b = Profile::index(start, length, Pps(4000), soft);
    EXPECT_NEAR(seconds(a.end() - b.end()), 0, 1e-7);
    check(a, 0, length);
    check(b, 0, length);
  }
}

TEST(ProfileShapes, AnSCurveBeginsAndEndsItsRampSoftly) {
  const Profile p =
      Profile::index(start, 100'000, Pps(4100), Ramp(10'000, 10'000, Pps(100), RampShape::s_curve));
  const auto speed_after = [&](double s) { return p.speed(start + from_seconds(s)).value; };
  EXPECT_NEAR(speed_after(0.2), 2100, 1) << "half way in the middle";
  EXPECT_NEAR(speed_after(0.1), 100 + 4000 / 8.0, 1);
  EXPECT_NEAR(speed_after(0.3), 4100 - 4000 / 8.0, 1);
  EXPECT_NEAR(speed_after(0.4), 4100, 1);
}

TEST(ProfileShapes, ApproachComesToItsEndAtTheStartSpeed) {
  const Ramp ramp(8'000, 6'000, Pps(200));
  for (const double now : {200.0, 1000.0, 5000.0})
    for (const double wanted : {300.0, 1000.0, 9000.0})
      for (const std::int64_t way : {3, 400, 3'000, 80'000}) {
        const Profile p = Profile::approach(start, 50.25, Pps(now), Pps(wanted), 7'000, ramp, 50 + way);
        check(p, 50, 50 + way);
        EXPECT_LE(p.final_speed().value, std::max(now, 200.0) + 1e-6);
        if (way == 80'000) {
          EXPECT_NEAR(p.final_speed().value, 200, 1e-6);
          EXPECT_NEAR(p.speed(start + std::chrono::seconds(2)).value, wanted, 1e-6);
        }
      }
}

TEST(ProfileShapes, RampDownEndsAtItsStartSpeedOnAWholeStep) {
  for (const RampShape shape : {RampShape::linear, RampShape::s_curve}) {
    const Ramp ramp(5'000, 5'000, Pps(500), shape);
    const Profile p = Profile::ramp_down(start, 1000.5, Pps(3000), ramp);
    check(p, 1000, std::llround(1000.5 + (9e6 - 25e4) / 1e4));
    EXPECT_NEAR(p.final_speed().value, 500, 1e-9);
    EXPECT_EQ(p.phase(start + std::chrono::milliseconds(1)), Phase::decelerating);
    const Profile slow = Profile::ramp_down(start, 7.9, Pps(400), ramp);
    EXPECT_EQ(slow.end(), start);
    EXPECT_EQ(slow.length(), 7);
  }
}

TEST(ProfileShapes, HalfACosineTakesTheTimeOfItsTrapezoid) {
  const Ramp straight(10'000, 5'000, Pps(100)), soft(10'000, 5'000, Pps(100), RampShape::half_cosine);
  for (const std::int64_t length : {5, 100, 5'000, 100'000}) {
    const Profile a = Profile::index(start, length, Pps(4000), straight);
    const Profile b = Profile::index(start, length, Pps(4000), soft);
    EXPECT_NEAR(seconds(a.end() - b.end()), 0, 1e-7);
    check(b, 0, length);
  }
}

TEST(ProfileShapes, HalfACosineAcceleratesAsHalfASine) {
  const Profile p =
      Profile::index(start, 100'000, Pps(4100), Ramp(10'000, 10'000, Pps(100), RampShape::half_cosine));
  const auto speed_after = [&](double s) { return p.speed(start + from_seconds(s)).value; };
  EXPECT_NEAR(speed_after(0.2), 2100, 1);
  EXPECT_NEAR(speed_after(0.1), 100 + 4000 * (1 - std::sqrt(0.5)) / 2, 0.1);
  EXPECT_NEAR(speed_after(0.4), 4100, 1e-3);
  const double peak = (speed_after(0.201) - speed_after(0.199)) / 0.002;
  EXPECT_NEAR(peak, 10'000 * 3.14159265 / 2, 1) << "decision M45";
  EXPECT_NEAR((speed_after(0.001) - 100) / 0.001, 0, 100) << "no jerk at the beginning";
}

Ramp parabola(double truncation, double top) {
  Ramp r(10'000, 10'000, Pps(100), RampShape::parabolic);
  r.truncation = truncation, r.top = Pps(top);
  return r;
}

TEST(ProfileShapes, AParabolaLosesAccelerationAsItGetsFaster) {
  const Profile p = Profile::index(start, 100'000, Pps(4100), parabola(0.5, 0));
  const auto speed_after = [&](double s) { return p.speed(start + from_seconds(s)).value; };
  const auto accel_at = [&](double s) { return (speed_after(s + 1e-4) - speed_after(s - 1e-4)) / 2e-4; };
  EXPECT_NEAR(accel_at(0.001), 10'000, 20);
  // Half of it gone where the speed is: v = 100 + 8000 (1 - exp(-t / 0.8)).
  const double ramp_s = 0.8 * std::log(2);
  EXPECT_NEAR(speed_after(ramp_s), 4100, 0.01);
  EXPECT_NEAR(accel_at(ramp_s - 0.001), 5000, 10);
  EXPECT_NEAR(speed_after(ramp_s / 2), 100 + 8000 * (1 - std::exp(-ramp_s / 1.6)), 0.01);
  check(p, 0, 100'000);
  // Down as it came up.
  EXPECT_NEAR(p.speed(p.end() - from_seconds(ramp_s / 2)).value, speed_after(ramp_s / 2), 0.01);
}

TEST(ProfileShapes, AParabolaTooShortForItsSpeedKeepsItsCurve) {
  for (const double truncation : {0.1, 0.5, 0.95})
    for (const std::int64_t length : {1, 7, 300, 1'500}) {
      const Profile p = Profile::index(start, length, Pps(4100), parabola(truncation, 0));
      check(p, 0, length);
      const double middle = p.speed(p.start() + (p.end() - p.start()) / 2).value;
      EXPECT_LT(middle, 4100);
      EXPECT_GE(middle, 100);
    }
}

TEST(ProfileShapes, AStopDownAParabolaTakesTheRestOfIt) {
  // From half the speed there is more acceleration left than from all of it.
  const Profile slow = Profile::ramp_down(start, 0, Pps(2100), parabola(0.5, 4100));
  const Profile lone = Profile::ramp_down(start, 0, Pps(2100), parabola(0.5, 0));
  EXPECT_LT(slow.length(), lone.length());
  check(slow, 0, slow.length());
  // Way between the speeds: integral of v / (10000 (1 - (v - 100) / 8000)).
  const double w = 2000, log = std::log(1 - w / 8000);
  EXPECT_NEAR(static_cast<double>(slow.length()),
              -(8000 * w + 8000.0 * 8000 * log + 100 * 8000 * log) / 10'000, 1);
}

TEST(ProfileShapes, EveryShapeChangesSpeedOnTheMove) {
  for (const RampShape shape :
       {RampShape::linear, RampShape::s_curve, RampShape::half_cosine, RampShape::parabolic}) {
    Ramp ramp(8'000, 6'000, Pps(200), shape);
    ramp.truncation = 0.7, ramp.top = Pps(6000);
    for (const double now : {200.0, 1000.0, 5000.0})
      for (const double wanted : {300.0, 1000.0, 5500.0}) {
        for (const std::int64_t way : {3, 400, 3'000, 80'000})
          check(Profile::approach(start, 50.25, Pps(now), Pps(wanted), 6'000, ramp, 50 + way), 50, 50 + way);
        const Profile p = Profile::change(start, 50.25, Pps(now), Pps(wanted), ramp, Profile::endless);
        EXPECT_NEAR(p.speed(start).value, now, 1e-6);
        EXPECT_NEAR(p.speed(start + std::chrono::seconds(5)).value, wanted, 1e-6);
      }
  }
}

TEST(ProfileShapes, PhasesFollowTheRamps) {
  const Profile p = Profile::index(start, 10'000, Pps(1000), Ramp(1000, 2000, Pps(100)));
  EXPECT_EQ(p.phase(start), Phase::accelerating);
  EXPECT_EQ(p.phase(start + std::chrono::seconds(2)), Phase::constant);
  EXPECT_EQ(p.phase(p.end() - std::chrono::milliseconds(10)), Phase::decelerating);
  EXPECT_EQ(p.phase(p.end()), Phase::ended);
}

}  // namespace
}  // namespace hw::motion
