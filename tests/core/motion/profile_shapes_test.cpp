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

TEST(ProfileShapes, PhasesTellTheRamps) {
  const Profile p = Profile::index(start, 10'000, Pps(1000), Ramp(1000, 2000, Pps(100)));
  EXPECT_EQ(p.phase(start), Phase::accelerating);
  EXPECT_EQ(p.phase(start + std::chrono::seconds(2)), Phase::constant);
  EXPECT_EQ(p.phase(p.end() - std::chrono::milliseconds(10)), Phase::decelerating);
  EXPECT_EQ(p.phase(p.end()), Phase::ended);
}

}  // namespace
}  // namespace hw::motion
