// Servo axes with a motor on the bench, step axes with and without encoder: loops, slip, holding, tracking.
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/core/devices/vme58/stage.h"

namespace hw::vme58 {
namespace {

Stage with_motor(double kp, double kd, double ki = 0) {
  Stage s;
  AxisPlace p;
  p.motor = Motor();
  EXPECT_TRUE(s.motion.place(X, p));
  Gains& g = s.motion.settings(X).gains;
  g.proportional = kp, g.differential = kd, g.integral = ki;
  s.motion.changed(X);
  s.settle(1);
  return s;
}

struct Reply {
  double overshoot;
  int crossings;
};

/// A move as steep as the board can command it: the command is there after a few updates.
Reply step(Stage& s, std::int64_t by) {
  s.speeds(X, 1'000'000, 8'000'000, 500'000);
  EXPECT_TRUE(s.move({{X, by}}));
  Reply r{};
  bool below = true;
  const Instant end = s.motion.now() + from_seconds(1);
  while (s.motion.now() < end) {
    s.wait(0.0005);
    const std::int64_t at = s.motion.encoder(X);
    r.overshoot = std::max(r.overshoot, static_cast<double>(at) / static_cast<double>(by) - 1);
    if (at != by && (at < by) != below) ++r.crossings, below = at < by;
  }
  return r;
}

TEST(VmeServo, GoodGainsHardlyOvershoot) {
  Stage s = with_motor(2, 6);
  const Reply r = step(s, 200);
  EXPECT_LT(r.overshoot, 0.05);
  EXPECT_LT(r.crossings, 2);
  EXPECT_NEAR(s.motion.encoder(X), 200, 2);
  EXPECT_EQ(s.motion.position(X), 200);
}

TEST(VmeServo, BadGainsRing) {
  Stage s = with_motor(2, 0);
  const Reply r = step(s, 200);
  EXPECT_GT(r.overshoot, 0.25);
  EXPECT_GE(r.crossings, 5);
}

TEST(VmeServo, GainsTakeEffectWhileItRings) {
  Stage s = with_motor(2, 0);
  (void)step(s, 200);
  s.motion.settings(X).gains.differential = 6;
  s.motion.changed(X);
  s.settle(2);
  EXPECT_NEAR(s.motion.encoder(X), 200, 2);
  EXPECT_FALSE(s.motion.next_event()) << "a loop at rest sleeps";
}

TEST(VmeServo, AnAxisWithoutAMotorIsIdealWhateverItsGains) {
  Stage s;
  s.motion.settings(X).gains.proportional = 1e9;
  s.motion.changed(X);
  s.speeds(X, 5000, 50'000);
  s.move({{X, 4000}});
  s.wait(0.3);
  EXPECT_EQ(s.motion.encoder(X), s.motion.position(X));
  EXPECT_NE(s.motion.position(X), 0);
  s.settle();
  EXPECT_EQ(s.motion.encoder(X), 4000);
}

TEST(VmeServo, WithoutGainsAMotorDoesNotFollow) {
  Stage s = with_motor(0, 0);
  s.speeds(X, 5000, 50'000);
  s.move({{X, 4000}});
  s.settle(5);
  EXPECT_EQ(s.motion.position(X), 4000);
  EXPECT_EQ(s.motion.encoder(X), 0);
}

TEST(VmeServo, ClosingTheLoopMakesNoJump) {
  Stage s = with_motor(2, 6);
  s.motion.settings(X).holding = false;
  s.motion.changed(X);
  s.motion.slip(X, 700);
  s.settle(1);
  EXPECT_EQ(s.motion.encoder(X), 700);
  s.motion.settings(X).holding = true;
  s.motion.changed(X);
  s.settle(1);
  EXPECT_EQ(s.motion.position(X), 700);
  EXPECT_EQ(s.motion.encoder(X), 700);
}

TEST(VmeServo, AMotorIsStoppedByTheSwitchItsLoadMeets) {
  Stage s = with_motor(4, 6);
  s.travel(X, -1000, 3000);
  s.speeds(X, 20'000, 200'000);
  s.move({{X, 20'000}});
  s.settle(5);
  EXPECT_EQ(s.count(What::limit_hit, X), 1);
  EXPECT_FALSE(s.motion.moving(X));
  EXPECT_GE(s.motion.position(X), 3000);
  EXPECT_LT(s.motion.position(X), 3300);
  EXPECT_NEAR(s.motion.encoder(X), s.motion.position(X), 2);
}

TEST(VmeServo, AMotorFindsHomeWhereItsLoadIs) {
  Stage s = with_motor(4, 6);
  s.home_zone(X, 2000, 2400);
  s.speeds(X, 5000, 50'000);
  s.motion.home(X, HomeOrder{Sign::plus, false, 0});
  s.settle(5);
  BenchView view;
  s.motion.look(view);
  EXPECT_NEAR(view.load_position[X].value - s.motion.encoder(X), 2000, 6) << "an update later at most";
  s.move({{X, 0}});
  s.settle(5);
  s.motion.look(view);
  EXPECT_NEAR(view.load_position[X].value, 2000, 6);
}

TEST(VmeServo, AStalledMotorSlipsAndWithTnIsSwitchedOff) {
  Stage s = with_motor(2, 6);
  s.motion.settings(X).slip_tolerance = 50;
  s.motion.settings(X).slip_kills = true;
  s.motion.changed(X);
  s.motion.jam(X, true);
  s.speeds(X, 5000, 50'000);
  s.move({{X, 4000}});
  s.settle(5);
  EXPECT_EQ(s.count(What::slipped, X), 1);
  EXPECT_FALSE(s.motion.moving(X));
  EXPECT_FALSE(s.motion.settings(X).holding);
  EXPECT_LT(s.motion.position(X), 80);
  EXPECT_EQ(s.motion.axis(X).loop.volts(), 0);
}

TEST(VmeServo, InPositionWaitsForTheMotor) {
  Stage s = with_motor(2, 6);
  s.motion.settings(X).hold_deadband = 5;
  s.motion.changed(X);
  s.speeds(X, 50'000, 2'000'000);
  s.move({{X, 2000}});
  s.settle(0.066);
  ASSERT_FALSE(s.motion.occupied(X));
  EXPECT_FALSE(s.motion.in_position(X)) << "the command is there, the motor is not";
  s.reported.clear();
  s.settle(2);
  EXPECT_TRUE(s.motion.in_position(X));
  EXPECT_EQ(s.count(What::ready, X), 1);
}

TEST(VmeServo, ACopyWithMotorGoesTheSameWay) {
  Stage s = with_motor(20, 6);
  s.speeds(X, 50'000, 2'000'000);
  s.move({{X, 3000}});
  s.wait(0.02);
  Stage twin = s;
  s.wait(0.1), twin.wait(0.1);
  EXPECT_EQ(s.motion.encoder(X), twin.motion.encoder(X));
}

TEST(VmeServo, AStepAxisTakesNoMotor) {
  Stage s("8");
  AxisPlace p;
  p.motor = Motor();
  EXPECT_FALSE(s.motion.place(X, p));
}

// --- slip and holding --------------------------------------------------------------------------------------

/// Two encoder counts and a half for each step, as ER1000,400 says.
Stage stepper() {
  Stage s("4E");
  AxisPlace p;
  p.counts_per_step = 2.5;
  EXPECT_TRUE(s.motion.place(X, p));
  AxisSettings& x = s.motion.settings(X);
  x.encoder_counts_per_ratio = 1000, x.motor_counts_per_ratio = 400;
  s.motion.changed(X);
  s.speeds(X, 1000, 10'000);
  return s;
}

TEST(VmeStepper, CountsItsEncoder) {
  Stage s = stepper();
  s.move({{X, 400}});
  s.settle();
  EXPECT_EQ(s.motion.position(X), 400);
  EXPECT_EQ(s.motion.encoder(X), 1000);
  s.motion.load_position(X, 0);
  EXPECT_EQ(s.motion.encoder(X), 0);
  Stage bare("8");
  bare.move({{X, 400}});
  bare.settle();
  EXPECT_EQ(bare.motion.encoder(X), 400) << "without encoder: the command";
}

TEST(VmeStepper, AJamIsSeenAtTheCountBeyondTheTolerance) {
  Stage s = stepper();
  s.motion.settings(X).slip_tolerance = 100;
  s.motion.changed(X);
  s.motion.jam(X, true);
  s.move({{X, 4000}});
  s.settle();
  ASSERT_EQ(s.count(What::slipped, X), 1);
  EXPECT_EQ(s.find(What::slipped)->position, 41) << "41 steps are 103 counts, 40 are 100";
  EXPECT_EQ(s.motion.position(X), 4000) << "without TN it only tells";
  Stage kills = stepper();
  kills.motion.settings(X).slip_tolerance = 100, kills.motion.settings(X).slip_kills = true;
  kills.motion.settings(X).holding = true;
  kills.motion.changed(X);
  kills.motion.jam(X, true);
  kills.move({{X, 4000}});
  kills.settle();
  EXPECT_EQ(kills.motion.position(X), 41);
  EXPECT_FALSE(kills.motion.settings(X).holding);
}

TEST(VmeStepper, HoldingBringsTheLoadBack) {
  Stage s = stepper();
  AxisSettings& x = s.motion.settings(X);
  x.holding = true, x.hold_velocity = 1000, x.hold_gain = 50, x.hold_deadband = 2;
  s.motion.changed(X);
  s.motion.slip(X, 500);
  EXPECT_FALSE(s.motion.in_position(X));
  EXPECT_EQ(s.motion.encoder(X), 500);
  s.settle(10);
  EXPECT_TRUE(s.motion.in_position(X));
  EXPECT_LE(std::abs(s.motion.encoder(X)), 2);
  EXPECT_EQ(s.motion.position(X), 0) << "corrections do not count";
  EXPECT_GE(s.count(What::ready, X), 1);
  EXPECT_FALSE(s.motion.next_event());
  // 200 steps: at 1000/s down to 20, then in proportion.
  EXPECT_NEAR(seconds(s.motion.now()), 0.18 + std::log(20.0) / 50, 0.05);
}

TEST(VmeStepper, HoldingNeedsItsSpeedAndGain) {
  Stage s = stepper();
  s.motion.settings(X).holding = true;
  s.motion.changed(X);
  s.motion.slip(X, 500);
  s.settle(10);
  EXPECT_EQ(s.motion.encoder(X), 500);
}

TEST(VmeStepper, HoldingCatchesUpAfterAJam) {
  Stage s = stepper();
  AxisSettings& x = s.motion.settings(X);
  x.holding = true, x.hold_velocity = 1000, x.hold_gain = 50, x.hold_deadband = 2;
  s.motion.changed(X);
  s.motion.jam(X, true);
  s.move({{X, 100}});
  s.settle(5);
  EXPECT_EQ(s.motion.encoder(X), 0);
  s.motion.jam(X, false);
  s.settle(5);
  EXPECT_NEAR(s.motion.encoder(X), 250, 2);
}

TEST(VmeStepper, HoldingStopsAtALimit) {
  Stage s = stepper();
  AxisSettings& x = s.motion.settings(X);
  x.holding = true, x.hold_velocity = 1000, x.hold_gain = 50;
  s.motion.changed(X);
  s.motion.operate_limit(X, Sign::plus, true);
  s.motion.slip(X, -500);
  s.settle(5);
  EXPECT_EQ(s.motion.encoder(X), -500);
  s.motion.operate_limit(X, Sign::plus, false);
  s.settle(5);
  EXPECT_EQ(s.motion.encoder(X), 0);
}

TEST(VmeStepper, TrackingFollowsItsEncoderInput) {
  Stage s("4E");
  s.travel(X, -100, 2000);
  s.motion.settings(X).tracking = true;
  s.motion.changed(X);
  s.motion.slip(X, 750);
  EXPECT_EQ(s.motion.encoder(X), 750);
  EXPECT_EQ(s.motion.position(X), 750);
  s.motion.slip(X, -50);
  EXPECT_EQ(s.motion.position(X), 700);
  EXPECT_EQ(s.motion.direction(X), Sign::minus);
  s.motion.slip(X, 5000);
  s.listen();
  EXPECT_EQ(s.motion.position(X), 2000) << "not beyond the switch";
  EXPECT_EQ(s.count(What::limit_hit, X), 1);
  s.motion.settings(X).tracking = false;
  s.motion.changed(X);
  s.motion.slip(X, -10);
  EXPECT_EQ(s.motion.position(X), 2000);
}

TEST(VmeStepper, AnIdealServoThatSlipsIsPulledBackAndSeen) {
  Stage s;
  s.motion.settings(Y).slip_tolerance = 20;
  s.motion.changed(Y);
  s.motion.slip(Y, 15);
  s.listen();
  EXPECT_EQ(s.count(What::slipped, Y), 0);
  s.motion.slip(Y, 50);
  s.listen();
  EXPECT_EQ(s.count(What::slipped, Y), 1);
  EXPECT_EQ(s.motion.encoder(Y), 0);
}

}  // namespace
}  // namespace hw::vme58
