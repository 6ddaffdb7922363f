// Contours as the motion plays them, the third example of the data sheet first of all.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/core/devices/vme58/stage.h"

namespace hw::vme58 {
namespace {

using Kind = RecordedPiece::Kind;

RecordedPiece line(std::int64_t first, std::int64_t second) {
  RecordedPiece p;
  p.to = {first, second};
  return p;
}

RecordedPiece arc(std::int64_t first, std::int64_t second, double angle) {
  RecordedPiece p;
  p.kind = Kind::arc, p.centre_first = first, p.centre_second = second, p.angle = angle;
  return p;
}

RecordedPiece output(unsigned axes, bool high) {
  RecordedPiece p;
  p.kind = Kind::outputs, p.outputs = axes, p.high = high;
  return p;
}

Contour hole() {
  Contour c;
  c.axes = 1u << Z | 1u << T;
  c.pieces = {output(1u << X, true), arc(0, 5000, 3.1415926), arc(0, 0, 6.2831853), output(1u << X, false),
              line(-10, 10'000)};
  c.complete = true;
  return c;
}

Stage ready(double cv = 1000) {
  Stage s;
  s.motion.board().contour_velocity = cv;
  for (int a = 0; a < most_axes; ++a) s.speeds(a, 5000, 10'000);
  return s;
}

TEST(VmeContour, TheHoleOfTheDataSheet) {
  Stage s = ready();
  s.move({{Z, -1000}, {T, 0}});
  s.settle();
  s.reported.clear();
  const Instant begins = s.motion.now();
  ASSERT_TRUE(s.motion.play(hole()));
  EXPECT_TRUE(s.motion.occupied(Z));
  s.listen();
  while (s.motion.moving(Z)) {
    s.wait(0.1);
    const Reported* on = s.find(What::output, X);
    const bool cuts = s.count(What::output, X) == 1 && on != nullptr;
    const double t = seconds(s.motion.now() - begins);
    const double out = 1.05 + 5 * std::numbers::pi;
    const auto z = static_cast<double>(s.motion.position(Z)), tt = static_cast<double>(s.motion.position(T));
    if (cuts && t < out) {
      EXPECT_NEAR(std::hypot(z, tt - 5000), 5000, 1);
    } else if (cuts) {
      EXPECT_NEAR(std::hypot(z, tt), 10'000, 1);
      EXPECT_NEAR(std::hypot(s.motion.velocity(Z), s.motion.velocity(T)), 1000, 1);
    }
  }
  // Both ends of the cut: the centre, and the start of the hole.
  ASSERT_EQ(s.count(What::output, X), 2);
  const double at_speed = 1.05;  // 1000 counts of lead-in, 0.1 s of ramp
  EXPECT_NEAR(seconds(s.find(What::output, X)->at - begins), at_speed, 1e-3);
  const double cut = at_speed + 25 * std::numbers::pi;
  EXPECT_NEAR(seconds(s.find(What::rested, Z)->at - begins), cut + 0.01 + 0.1, 2e-3);
  // The last piece goes 10 counts to the left, the ramp 50 more (decision M73).
  EXPECT_NEAR(s.motion.position(Z), -60, 1);
  EXPECT_EQ(s.motion.position(T), 10'000);
  EXPECT_EQ(s.motion.position(X), 0);
}

TEST(VmeContour, CkStopsDeadAtTheEnd) {
  Stage s = ready();
  Contour c = hole();
  c.kill = true;
  ASSERT_TRUE(s.motion.play(c));
  s.settle();
  EXPECT_EQ(s.motion.position(Z), -10);
  EXPECT_EQ(s.motion.position(T), 10'000);
}

TEST(VmeContour, ALeadInTooShortJumpsToPathSpeed) {
  Stage s = ready();
  Contour c;
  c.axes = 1u << X | 1u << Y, c.complete = true;
  c.pieces = {line(3000, 4000)};
  ASSERT_TRUE(s.motion.play(c));
  s.wait(0.001);
  EXPECT_NEAR(std::hypot(s.motion.velocity(X), s.motion.velocity(Y)), 1000, 1);
  s.settle();
  EXPECT_NEAR(seconds(s.motion.now()), 5 + 0.1, 1e-3);
  EXPECT_EQ(s.motion.position(X), 3030);
  EXPECT_EQ(s.motion.position(Y), 4040);
}

TEST(VmeContour, ThreeAxesRunAtPathSpeedRoundACorner) {
  Stage s = ready();
  s.speeds(Y, 5000, 2000);  // the gentlest ramp counts (decision M76)
  Contour c;
  c.axes = 1u << X | 1u << Y | 1u << T, c.complete = true;
  RecordedPiece p;
  p.to = {1000, 0, 0};
  c.pieces.push_back(p);
  p.to = {1000, 2000, 2000};
  c.pieces.push_back(p);
  ASSERT_TRUE(s.motion.play(c));
  s.wait(0.5);
  EXPECT_NEAR(s.motion.velocity(X), 1000, 1);
  s.wait(1);
  EXPECT_NEAR(s.motion.velocity(X), 0, 1e-6);
  EXPECT_NEAR(s.motion.velocity(Y), 1000 / std::numbers::sqrt2, 1);
  EXPECT_NEAR(s.motion.velocity(T), 1000 / std::numbers::sqrt2, 1);
  s.settle();
  EXPECT_EQ(s.motion.position(X), 1000);
  EXPECT_NEAR(s.motion.position(T), 2000 + 250 / std::numbers::sqrt2, 1);
}

TEST(VmeContour, ALimitOnTheWayEndsIt) {
  Stage s = ready();
  s.travel(T, -100'000, 5000);
  s.motion.play(hole());
  s.settle();
  EXPECT_EQ(s.motion.position(T), 5000);
  EXPECT_NEAR(s.motion.position(Z), 5000, 1);
  EXPECT_EQ(s.count(What::limit_hit, T), 1);
  EXPECT_FALSE(s.motion.occupied(Z));
}

TEST(VmeContour, AStopRampsDownAlongIt) {
  Stage s = ready();
  s.motion.play(hole());
  s.wait(30);
  s.motion.stop(Z);
  s.settle();
  const double r =
      std::hypot(static_cast<double>(s.motion.position(Z)), static_cast<double>(s.motion.position(T)));
  EXPECT_NEAR(r, 10'000, 1);
  EXPECT_FALSE(s.motion.moving(T));
  EXPECT_EQ(s.count(What::rested, Z), 1);
}

TEST(VmeContour, FlLetsItsAxesRunOnStraight) {
  Stage s = ready();
  s.motion.play(hole());
  s.wait(5);
  const double vz = s.motion.velocity(Z), vt = s.motion.velocity(T);
  s.motion.keep_velocity(Z), s.motion.keep_velocity(T);
  s.wait(10);
  EXPECT_NEAR(s.motion.velocity(Z), vz, 1e-6);
  EXPECT_NEAR(s.motion.velocity(T), vt, 1e-6);
  EXPECT_NEAR(std::hypot(vz, vt), 1000, 1e-3);
}

TEST(VmeContour, RefusesWithoutSpeedOrWithAServoOff) {
  Stage s = ready(0);
  EXPECT_FALSE(s.motion.play(hole()));
  s.motion.board().contour_velocity = 1000;
  Contour open = hole();
  open.complete = false;
  EXPECT_FALSE(s.motion.play(open));
  s.motion.settings(T).holding = false;
  s.motion.changed(T);
  EXPECT_FALSE(s.motion.play(hole()));
}

TEST(VmeContour, OneWithoutAnyWayIsOverAtOnce) {
  Stage s = ready();
  Contour c;
  c.axes = 1u << X, c.complete = true;
  c.pieces = {output(1u << Y, true)};
  ASSERT_TRUE(s.motion.play(c));
  s.settle();
  EXPECT_EQ(s.count(What::output, Y), 1);
  EXPECT_FALSE(s.motion.moving(X));
}

}  // namespace
}  // namespace hw::vme58
