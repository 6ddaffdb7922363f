// The motion of the board by itself: ramps, lines, jogs, limits, counters. What the text of the
// commands does with it is tested by vme58.forms.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/devices/vme58/stage.h"

namespace hw::vme58 {
namespace {

TEST(VmeMotion, AMoveTakesTheTimeOfItsRamps) {
  Stage s;
  s.speeds(X, 1000, 10'000);
  ASSERT_TRUE(s.move({{X, 1000}}));
  EXPECT_TRUE(s.motion.occupied(X));
  s.wait(0.05);
  EXPECT_NEAR(s.motion.velocity(X), 500, 1);
  EXPECT_EQ(s.motion.position(X), 12);
  s.settle();
  EXPECT_NEAR(seconds(s.motion.now()), 1.1, 1e-6);
  EXPECT_EQ(s.motion.position(X), 1000);
  EXPECT_EQ(s.motion.encoder(X), 1000);
  EXPECT_FALSE(s.motion.occupied(X));
  EXPECT_EQ(s.count(What::began), 1);
  EXPECT_EQ(s.count(What::rested), 1);
  EXPECT_EQ(s.motion.direction(X), Sign::plus);
}

TEST(VmeMotion, TheBaseVelocityNeedsNoRamp) {
  Stage s;
  s.speeds(X, 1000, 1000, 900);
  s.move({{X, -1000}});
  s.wait(1e-6);
  EXPECT_NEAR(s.motion.velocity(X), 900, 1);
  s.settle();
  EXPECT_EQ(s.motion.position(X), -1000);
  EXPECT_EQ(s.motion.direction(X), Sign::minus);
  // 0.1 s and 95 counts each for the ramps, 810 counts at speed.
  EXPECT_NEAR(seconds(s.motion.now()), 1.01, 1e-6);
}

TEST(VmeMotion, AxesOfALineArriveTogetherAtTheSpeedOfTheLongest) {
  Stage s;
  for (const int a : {X, Y, Z}) s.speeds(a, 5000, 50'000);
  s.speeds(X, 10, 10);  // not the longest: its speed does not matter (decision M48)
  ASSERT_TRUE(s.move({{X, 1000}, {Y, -2000}, {Z, 3000}}));
  s.wait(0.3);
  EXPECT_NEAR(s.motion.position(X) * 3.0, static_cast<double>(s.motion.position(Z)), 3);
  EXPECT_NEAR(s.motion.velocity(X), 5000.0 / 3, 1);
  EXPECT_NEAR(s.motion.velocity(Y), 2 * 5000.0 / 3, 1);
  EXPECT_EQ(s.motion.direction(Y), Sign::minus);
  s.settle();
  EXPECT_NEAR(seconds(s.motion.now()), 0.7, 1e-6);
  EXPECT_EQ(s.motion.position(X), 1000);
  EXPECT_EQ(s.motion.position(Y), -2000);
  EXPECT_EQ(s.motion.position(Z), 3000);
  EXPECT_EQ(s.find(What::rested, X)->at, s.find(What::rested, Z)->at);
}

TEST(VmeMotion, EightAxesMoveAsOneLine) {
  Stage s;
  std::vector<std::pair<int, std::int64_t>> goals;
  for (int a = 0; a < most_axes; ++a) s.speeds(a, 1000, 10'000), goals.emplace_back(a, 100 * (a + 1));
  ASSERT_TRUE(s.move(goals));
  s.settle();
  for (int a = 0; a < most_axes; ++a) EXPECT_EQ(s.motion.position(a), 100 * (a + 1));
}

TEST(VmeMotion, ShapesOfRampsHaveTheirTime) {
  const auto lasts = [](RampForm form, int truncation) {
    Stage s;
    s.motion.board().ramp = form, s.motion.board().truncation = truncation;
    s.speeds(X, 1000, 10'000);
    s.move({{X, 1000}});
    s.settle();
    EXPECT_EQ(s.motion.position(X), 1000);
    return seconds(s.motion.now());
  };
  EXPECT_NEAR(lasts(RampForm::linear, 0), 1.1, 1e-6);
  EXPECT_NEAR(lasts(RampForm::cosine, 0), 1.1, 1e-6);
  const double some = lasts(RampForm::parabolic, 3), more = lasts(RampForm::parabolic, 8);
  EXPECT_GT(some, 1.1);
  EXPECT_GT(more, some);
  EXPECT_LT(lasts(RampForm::parabolic, 10), 2) << "arrives";
}

TEST(VmeMotion, RefusesWhatItCannotReach) {
  Stage s;
  EXPECT_FALSE(s.move({{X, position_max + 1}}));
  s.motion.load_position(X, 33'000'000);
  EXPECT_FALSE(s.move({{X, 600'000}}, true));
  EXPECT_TRUE(s.move({{X, 500'000}}, true));
  EXPECT_TRUE(s.move({{Y, 0}})) << "no way to go is no error";
  EXPECT_FALSE(s.motion.moving(Y));
}

TEST(VmeMotion, AServoThatIsOffDoesNotMove) {
  Stage s;
  s.motion.settings(X).holding = false;
  s.motion.changed(X);
  EXPECT_FALSE(s.move({{X, 100}}));
  EXPECT_FALSE(s.move({{X, 100}, {Y, 100}}));
  EXPECT_FALSE(s.motion.jog(X, 100));
  EXPECT_FALSE(s.motion.home(X, {}));
  s.motion.settings(Y).holding = true;
  ASSERT_TRUE(s.motion.jog(Y, 1000));
  s.wait(0.5);
  s.motion.settings(Y).holding = false;
  s.motion.changed(Y);
  EXPECT_FALSE(s.motion.moving(Y)) << "HF under way";
}

TEST(VmeMotion, AJogChangesOnTheFlyAndTurnsRound) {
  Stage s;
  s.speeds(X, 100, 1000);
  ASSERT_TRUE(s.motion.jog(X, 1000));
  EXPECT_FALSE(s.motion.occupied(X));
  s.wait(2);
  EXPECT_NEAR(s.motion.velocity(X), 1000, 1e-6);
  EXPECT_EQ(s.motion.position(X), 1500);
  ASSERT_TRUE(s.motion.jog(X, 250));
  s.wait(0.75);
  EXPECT_NEAR(s.motion.velocity(X), 250, 1e-6);
  ASSERT_TRUE(s.motion.jog(X, -500));
  s.wait(0.25);
  EXPECT_NEAR(s.motion.velocity(X), 0, 5);
  EXPECT_FALSE(s.motion.occupied(X)) << "it is on the way to another speed";
  s.wait(0.5);
  EXPECT_NEAR(s.motion.velocity(X), 500, 5);
  EXPECT_EQ(s.motion.direction(X), Sign::minus);
  EXPECT_EQ(s.count(What::began), 1);
  EXPECT_EQ(s.count(What::rested), 0);
  EXPECT_FALSE(s.move({{X, 0}})) << "a move does not end a jog (decision M61)";
  ASSERT_TRUE(s.motion.jog(X, 0));
  EXPECT_TRUE(s.motion.occupied(X));
  s.settle();
  EXPECT_FALSE(s.motion.moving(X));
  EXPECT_EQ(s.count(What::rested), 1);
}

TEST(VmeMotion, AFractionalJogMakesACountInFourSeconds) {
  Stage s;
  ASSERT_TRUE(s.motion.jog(X, 0.25));
  s.wait(3.9);
  EXPECT_EQ(s.motion.position(X), 0);
  s.wait(0.2);
  EXPECT_EQ(s.motion.position(X), 1);
  s.wait(4);
  EXPECT_EQ(s.motion.position(X), 2);
  s.motion.stop(X);
  s.settle();
  EXPECT_EQ(s.motion.position(X), 2);
}

TEST(VmeMotion, AStopRampsAndAKillDoesNot) {
  Stage s;
  for (const int a : {X, Y}) s.speeds(a, 1000, 1000), s.motion.jog(a, 1000);
  s.wait(2);
  s.motion.stop(X), s.motion.kill(Y);
  EXPECT_TRUE(s.motion.moving(X));
  EXPECT_TRUE(s.motion.occupied(X));
  EXPECT_FALSE(s.motion.moving(Y));
  s.settle();
  EXPECT_EQ(s.motion.position(X), 2000);
  EXPECT_EQ(s.motion.position(Y), 1500);
}

TEST(VmeMotion, AStopOfALineStaysOnIt) {
  Stage s;
  s.speeds(X, 1000, 1000), s.speeds(Y, 1000, 1000);
  s.move({{X, 8000}, {Y, 2000}});
  s.wait(3);
  s.motion.stop(X);
  s.motion.stop(Y);
  s.settle();
  EXPECT_EQ(s.motion.position(X), 3000);
  EXPECT_EQ(s.motion.position(Y), 750);
}

TEST(VmeMotion, FlKeepsThePresentSpeed) {
  Stage s;
  s.speeds(X, 1000, 1000), s.speeds(Y, 1000, 1000);
  s.move({{X, 8000}, {Y, 2000}});
  s.wait(0.5);
  s.motion.keep_velocity(X);
  s.motion.keep_velocity(Y);
  EXPECT_FALSE(s.motion.occupied(X));
  s.wait(100);
  EXPECT_NEAR(s.motion.velocity(X), 500, 1e-6);
  EXPECT_NEAR(s.motion.velocity(Y), 125, 1e-6);
  EXPECT_NEAR(s.motion.position(X), 125 + 50'000, 2);
  EXPECT_NEAR(s.motion.position(Y), 31 + 12'500, 2);
  s.motion.stop(X);
  s.motion.keep_velocity(X);
  s.motion.kill(Y);
  s.settle();
  EXPECT_FALSE(s.motion.moving(X)) << "FL does not take a stop back";
}

TEST(VmeMotion, ALimitCutsAtItsCountOrRampsBeyondIt) {
  Stage s;
  for (const int a : {X, Y, Z}) s.speeds(a, 1000, 1000), s.travel(a, -500, 2500);
  s.motion.settings(Y).soft_limits = true;
  s.motion.settings(Z).limits_on = false;
  for (const int a : {X, Y, Z}) s.motion.changed(a), s.motion.jog(a, 1000);
  s.settle(10);
  EXPECT_EQ(s.motion.position(X), 2500);
  EXPECT_EQ(s.find(What::limit_hit, X)->position, 2500);
  EXPECT_NEAR(seconds(s.find(What::limit_hit, X)->at), 3, 1e-6);
  EXPECT_EQ(s.motion.position(Y), 3000);
  EXPECT_EQ(s.find(What::limit_hit, Y)->position, 2500);
  EXPECT_EQ(s.find(What::limit_hit, Z), nullptr);
  s.motion.kill(Z);
  EXPECT_TRUE(s.motion.limit_active(X));
  s.move({{X, 3000}});
  EXPECT_FALSE(s.motion.moving(X)) << "deeper into the switch";
  s.listen();
  EXPECT_EQ(s.count(What::limit_hit, X), 2);
  s.move({{X, 0}});
  s.settle();
  EXPECT_EQ(s.motion.position(X), 0) << "out of it";
  EXPECT_FALSE(s.motion.limit_active(X));
}

TEST(VmeMotion, ALimitOfOneAxisEndsTheLine) {
  Stage s;
  s.speeds(X, 1000, 10'000), s.speeds(Y, 1000, 10'000);
  s.travel(Y, -100, 300);
  s.move({{X, 2000}, {Y, 1000}});
  s.settle();
  EXPECT_EQ(s.motion.position(Y), 300);
  EXPECT_NEAR(s.motion.position(X), 599, 1);
}

TEST(VmeMotion, AHandOnASwitchStopsAtOnce) {
  Stage s;
  s.speeds(X, 1000, 10'000);
  s.motion.jog(X, 1000);
  s.wait(1);
  s.motion.operate_limit(X, Sign::minus, true);
  EXPECT_TRUE(s.motion.moving(X)) << "the other side";
  s.motion.operate_limit(X, Sign::plus, true);
  s.listen();
  EXPECT_FALSE(s.motion.moving(X));
  EXPECT_EQ(s.count(What::limit_hit, X), 1);
}

// --- counters ----------------------------------------------------------------------------------------------

TEST(VmeMotion, LoadingThePositionUnderWay) {
  Stage s;
  for (const int a : {X, Y, Z}) s.speeds(a, 1000, 1000);
  s.move({{X, 10'000}}, true);
  s.move({{Y, 10'000}});
  s.move({{Z, 3000}});
  s.wait(2);
  for (const int a : {X, Y}) s.motion.load_position(a, 1000);
  s.motion.load_position(Z, 2900);
  s.settle();
  EXPECT_EQ(s.motion.position(X), 9500) << "the target of a relative move shifts along";
  EXPECT_EQ(s.motion.position(Y), 10'000) << "an absolute one stands";
  EXPECT_EQ(s.motion.position(Z), 3000) << "too near to stop: there and back";
  EXPECT_EQ(s.motion.encoder(Z), 3000);
  EXPECT_EQ(s.count(What::rested, Z), 1);
}

TEST(VmeMotion, TheRemainderHasTheSignOfThePosition) {
  Stage s;
  s.motion.load_position(X, 1234), s.motion.load_position(Y, -1234);
  s.motion.remainder(X, 400), s.motion.remainder(Y, 400);
  EXPECT_EQ(s.motion.position(X), 34);
  EXPECT_EQ(s.motion.encoder(X), 34);
  EXPECT_EQ(s.motion.position(Y), -34);
}

TEST(VmeMotion, NearlyDoneComesAtItsCount) {
  Stage s;
  s.speeds(X, 1000, 10'000);
  s.motion.notify_at(X, 100);
  s.move({{X, 1000}});
  s.settle();
  ASSERT_NE(s.find(What::nearly_done), nullptr);
  EXPECT_EQ(s.find(What::nearly_done)->position, 900);
  EXPECT_EQ(s.count(What::nearly_done), 1);
  s.move({{X, 0}});
  s.wait(0.5);
  s.motion.notify_at(X, 5000);
  s.listen();
  EXPECT_EQ(s.count(What::nearly_done), 2) << "less than that is left already";
}

TEST(VmeMotion, ACopyGoesTheSameWay) {
  Stage s;
  s.speeds(X, 1000, 10'000);
  s.travel(X, -5000, 1800);
  s.motion.jog(X, 1000);
  s.wait(1);
  Stage twin = s;
  s.settle(5), twin.settle(5);
  EXPECT_EQ(s.motion.position(X), twin.motion.position(X));
  EXPECT_EQ(s.motion.now(), twin.motion.now());
}

}  // namespace
}  // namespace hw::vme58
