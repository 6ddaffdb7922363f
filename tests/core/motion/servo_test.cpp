// The loop of core/motion/servo.h with the motor that it names: a jump of the command, the end of a move, a
// load that pulls, a converter at its limit.
#include "core/motion/servo.h"

#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

namespace hw::motion {
namespace {

constexpr double update_s = 0.001;

ServoGains gains(double kp, double kd, double ki = 0) {
  ServoGains g;
  g.kp = kp, g.kd = kd, g.ki = ki;
  return g;
}

ServoLoop standing(const ServoGains& g) {
  ServoLoop loop;
  loop.gains = g;
  loop.close(true);
  for (int i = 0; i < 3; ++i) loop.tick(0, update_s);
  return loop;
}

struct Response {
  double overshoot = 0;  ///< share of the step
  int crossings = 0;
  int settled_after = 0;  ///< updates until it stays within 2%
  std::int64_t left = 0;  ///< error in the end
};

Response jump(ServoLoop& loop, double by, int updates) {
  Response r;
  bool below = true;
  double peak = 0;
  for (int i = 1; i <= updates; ++i) {
    loop.tick(by, update_s);
    const auto at = static_cast<double>(loop.plant.counts());
    peak = std::max(peak, at);
    if (at != by && (at < by) != below) ++r.crossings, below = at < by;
    if (std::abs(at - by) > std::max(2.0, 0.02 * by)) r.settled_after = i;
  }
  r.overshoot = peak / by - 1;
  r.left = loop.error();
  return r;
}

Response jump(const ServoGains& g, double by, int updates = 500) {
  ServoLoop loop = standing(g);
  return jump(loop, by, updates);
}

TEST(Servo, TheDataSheetsGainsDoNotOvershoot) {
  for (const double by : {200.0, 1000.0}) {
    const Response r = jump(gains(2, 6), by);
    EXPECT_LT(r.overshoot, 0.01);
    EXPECT_EQ(r.crossings, 0);
    EXPECT_LT(r.settled_after, 110);
    EXPECT_LE(std::abs(r.left), 2) << "dry friction holds it";
  }
}

TEST(Servo, GoodGainsWithAnIntegralStayUnderFivePercentAndCrossOnce) {
  for (const double by : {200.0, 1000.0}) {
    const Response r = jump(gains(4, 6, 4), by, 5000);
    EXPECT_LT(r.overshoot, 0.05);
    EXPECT_LE(r.crossings, 1);
    EXPECT_EQ(r.left, 0) << "the sum pulls in what friction holds";
  }
}

TEST(Servo, BadGainsRing) {
  for (const double by : {200.0, 1000.0}) {
    for (const ServoGains& bad : {gains(2, 0), gains(30, 5), gains(2, 0, 1)}) {
      const Response r = jump(bad, by);
      EXPECT_GT(r.overshoot, 0.25) << "KP" << bad.kp << " KD" << bad.kd;
      EXPECT_GE(r.crossings, 5) << "KP" << bad.kp << " KD" << bad.kd;
    }
  }
}

/// Largest error on the way of a move at 20 counts an update, ramped over 100 updates.
std::int64_t worst_error(const ServoGains& g) {
  ServoLoop loop = standing(g);
  double command = 0, speed = 0;
  std::int64_t worst = 0;
  for (int i = 0; i < 600; ++i) {
    if (i < 100) speed += 0.2;
    if (i >= 500) speed -= 0.2;
    command += speed;
    loop.tick(command, update_s);
    worst = std::max<std::int64_t>(worst, std::abs(loop.error()));
  }
  return worst;
}

TEST(Servo, FeedforwardTakesTheErrorOutOfAMove) {
  ServoGains g = gains(2, 6);
  const std::int64_t without = worst_error(g);
  EXPECT_GE(without, 8);
  g.kv = 0.2, g.ka = 2.5;
  EXPECT_LE(worst_error(g), without / 3);
}

TEST(Servo, TheOffsetHoldsASteadyLoadThatKoKnows) {
  // An open converter gives no torque; KO alone drives the motor of a closed one.
  ServoLoop loop = standing(gains(0, 0));
  loop.gains.ko = 204.8;
  loop.wake();
  for (int i = 0; i < 50; ++i) loop.tick(0, update_s);
  EXPECT_NEAR(loop.volts(), 1.0, 0.01);
  EXPECT_NEAR(loop.plant.torque(), 0.1, 0.001);
  EXPECT_GT(loop.plant.counts(), 1000);
}

TEST(Servo, ALongerIntervalSumsSlower) {
  const auto after = [](int kn) {
    ServoLoop loop = standing(gains(0, 0, 1));
    loop.gains.kn = kn;
    loop.plant.jam(true);
    for (int i = 0; i < 1024; ++i) loop.tick(256, update_s);
    return loop.output();
  };
  EXPECT_EQ(after(0), 1024);
  EXPECT_EQ(after(3), 1024 / 8);
  EXPECT_EQ(after(10), 1);
}

TEST(Servo, TheConverterHasTwelveBitsAndTheSumDoesNotWindUp) {
  ServoLoop loop = standing(gains(2, 6, 4));
  loop.plant.jam(true);
  for (int i = 0; i < 20'000; ++i) loop.tick(1000, update_s);
  EXPECT_EQ(loop.output(), output_limit);
  EXPECT_NEAR(loop.volts(), 10, 0.01);
  loop.plant.jam(false);
  const Response r = jump(loop, 1000, 3000);
  EXPECT_LE(std::abs(r.left), 2) << "comes to rest after a stall of twenty seconds";
}

TEST(Servo, RestsOnceNothingChangesAndSleepsThroughIt) {
  ServoLoop loop = standing(gains(2, 6));
  EXPECT_TRUE(loop.at_rest());
  loop.tick(500, update_s);
  EXPECT_FALSE(loop.at_rest());
  int awake = 0;
  while (!loop.at_rest() && awake < 2000) loop.tick(500, update_s), ++awake;
  EXPECT_LT(awake, 500);
  const ServoLoop before = loop;
  loop.tick(500, update_s);
  EXPECT_EQ(loop.plant.counts(), before.plant.counts());
  EXPECT_EQ(loop.output(), before.output());
}

TEST(Servo, ACopyGoesTheSameWay) {
  ServoLoop loop = standing(gains(20, 6));
  for (int i = 0; i < 7; ++i) loop.tick(300, update_s);
  ServoLoop twin = loop;
  for (int i = 0; i < 300; ++i) {
    loop.tick(300, update_s), twin.tick(300, update_s);
    ASSERT_EQ(loop.plant.counts(), twin.plant.counts());
    ASSERT_EQ(loop.output(), twin.output());
  }
}

TEST(Servo, AnOpenLoopLetsTheShaftRunOut) {
  ServoLoop loop = standing(gains(2, 6));
  for (int i = 0; i < 8; ++i) loop.tick(5000, update_s);
  const double speed = loop.plant.speed();
  EXPECT_GT(speed, 0);
  loop.close(false);
  for (int i = 0; i < 2000; ++i) loop.tick(5000, update_s);
  EXPECT_EQ(loop.output(), 0);
  EXPECT_EQ(loop.plant.speed(), 0) << "friction has the last word";
  EXPECT_TRUE(loop.at_rest());
}

TEST(Motor, MovesInClosedFormWhateverTheTick) {
  MotorModel once, often;
  once.turn(2, 0.05);
  for (int i = 0; i < 500; ++i) often.turn(2, 0.0001);
  EXPECT_NEAR(once.speed(), often.speed(), 1e-6 * once.speed());
  EXPECT_NEAR(static_cast<double>(once.counts()), static_cast<double>(often.counts()), 1);
  // Against its own motion: stands on the way, and turns round.
  once.turn(-1, 0.4), often.turn(-1, 0.1), often.turn(-1, 0.3);
  EXPECT_LT(once.speed(), 0);
  EXPECT_NEAR(once.speed(), often.speed(), 1e-6 * std::abs(once.speed()));
}

TEST(Motor, SticksBelowItsFriction) {
  MotorModel m;
  m.turn(0.019, 10);
  EXPECT_EQ(m.counts(), 0);
  EXPECT_TRUE(m.still_at(0.019));
  m.turn(0.021, 1);
  EXPECT_GT(m.counts(), 0);
}

TEST(Motor, TheTorqueLimitBoundsItsAcceleration) {
  Motor weak;
  weak.torque_limit = 0.05, weak.friction = 0, weak.viscous = 0;
  MotorModel m(weak);
  m.turn(10, 0.1);
  EXPECT_NEAR(m.torque(), 0.05, 1e-12);
  EXPECT_NEAR(m.speed(), 0.1 * 0.05 / 5e-5 * 4000 / (2 * 3.14159265358979), 1);
}

}  // namespace
}  // namespace hw::motion
