// Homing and staircases, by the motion of the board itself.
#include <gtest/gtest.h>

#include "tests/core/devices/vme58/stage.h"

namespace hw::vme58 {
namespace {

TEST(VmeHome, TheEdgeGetsThePositionAndARampFollows) {
  Stage s;
  s.speeds(X, 1000, 10'000);
  s.home_zone(X, 2000, 2400);
  ASSERT_TRUE(s.motion.home(X, HomeOrder{Sign::plus, false, 100}));
  EXPECT_TRUE(s.motion.occupied(X));
  s.settle();
  // The edge is at 2000; v²/2a is 50 (decision M40).
  EXPECT_EQ(s.motion.position(X), 150);
  EXPECT_EQ(s.motion.encoder(X), 150);
  BenchView view;
  s.motion.look(view);
  EXPECT_EQ(view.load_position[X].value, 2050);
  EXPECT_TRUE(s.motion.home_active(X));
  // Back to the edge: the count at which the switch acts.
  s.move({{X, 100}});
  s.settle();
  EXPECT_TRUE(s.motion.home_active(X));
  s.move({{X, 99}});
  s.settle();
  EXPECT_FALSE(s.motion.home_active(X));
}

TEST(VmeHome, BackwardsItIsTheOtherEdge) {
  Stage s;
  s.speeds(X, 1000, 10'000);
  s.home_zone(X, -2400, -2000);
  s.motion.home(X, HomeOrder{Sign::minus, false, 0});
  s.settle();
  EXPECT_EQ(s.motion.position(X), -50);
  BenchView view;
  s.motion.look(view);
  EXPECT_EQ(view.load_position[X].value, -2050);
}

TEST(VmeHome, TheKillingFormsStopDeadAndKeepTheCounter) {
  Stage s;
  s.speeds(X, 1000, 10'000), s.speeds(Y, 1000, 10'000);
  s.home_zone(X, 2000, 2400), s.home_zone(Y, -2400, -2000);
  s.motion.load_position(X, 7);
  s.motion.home(X, HomeOrder{Sign::plus, true, 0});
  s.motion.home(Y, HomeOrder{Sign::minus, true, 0});
  s.settle();
  EXPECT_EQ(s.motion.position(X), 2007);
  EXPECT_EQ(s.motion.position(Y), -2000);
}

TEST(VmeHome, ActiveAlreadyIsFoundWhereItStands) {
  Stage s;
  s.home_zone(X, -10, 10);
  s.motion.home(X, HomeOrder{Sign::plus, false, 500});
  s.settle();
  EXPECT_EQ(s.motion.position(X), 500);
  BenchView view;
  s.motion.look(view);
  EXPECT_EQ(view.load_position[X].value, 0);
}

TEST(VmeHome, HighSenseLooksForTheReleasedSwitch) {
  Stage s;
  s.speeds(X, 1000, 10'000);
  s.home_zone(X, -10, 300);
  s.motion.settings(X).home_active_high = true;
  s.motion.changed(X);
  EXPECT_FALSE(s.motion.home_active(X));
  s.motion.home(X, HomeOrder{Sign::plus, true, 0});
  s.settle();
  EXPECT_EQ(s.motion.position(X), 301);
  EXPECT_TRUE(s.motion.home_active(X));
}

TEST(VmeHome, WithTheEncoderItIsTheIndexWithinTheZone) {
  Stage s;
  s.speeds(X, 1000, 10'000);
  s.home_zone(X, 2100, 2900, 400);
  s.motion.settings(X).home_needs_index = true;
  s.motion.changed(X);
  s.motion.home(X, HomeOrder{Sign::plus, true, 0});
  s.settle();
  EXPECT_EQ(s.motion.position(X), 2400) << "the first mark behind 2100";
  EXPECT_TRUE(s.motion.encoder_home_active(X));
  s.move({{X, 5000}});
  s.settle();
  s.motion.home(X, HomeOrder{Sign::minus, false, 0});
  s.settle();
  EXPECT_EQ(s.motion.position(X), -50) << "2800 is the first mark from above";
  BenchView view;
  s.motion.look(view);
  EXPECT_EQ(view.load_position[X].value, 2750);
}

TEST(VmeHome, WithoutAnIndexTheEncoderFormRunsToTheLimit) {
  Stage s;
  s.speeds(X, 1000, 10'000);
  s.home_zone(X, 2000, 2400);
  s.travel(X, -5000, 5000);
  s.motion.settings(X).home_needs_index = true;
  s.motion.changed(X);
  s.motion.home(X, HomeOrder{Sign::plus, false, 0});
  s.settle();
  EXPECT_EQ(s.motion.position(X), 5000);
  EXPECT_EQ(s.count(What::limit_hit, X), 1);
  EXPECT_FALSE(s.motion.occupied(X));
}

TEST(VmeHome, AHandOnTheSwitchIsAnEdgeToo) {
  Stage s;
  s.speeds(X, 1000, 10'000);
  s.motion.home(X, HomeOrder{Sign::plus, false, 0});
  s.wait(1);
  s.motion.operate_home(X, true);
  s.settle();
  EXPECT_EQ(s.motion.position(X), 50);
}

// --- staircase ---------------------------------------------------------------------------------------------

TEST(VmeStaircase, StepsAtTheirPlacesAndStopsAtTheLast) {
  Stage s;
  s.speeds(X, 1000, 10'000);
  s.motion.set_direction(X, Sign::plus);
  ASSERT_TRUE(s.motion.move_velocity(X, 10'000, 2000));
  EXPECT_TRUE(s.motion.occupied(X));
  s.wait(5.099);
  EXPECT_TRUE(s.motion.occupied(X));
  s.wait(0.002);
  EXPECT_FALSE(s.motion.occupied(X)) << "10000 counts at 2000/s, and half of the ramp";
  EXPECT_NEAR(s.motion.velocity(X), 2000, 1e-6) << "runs on";
  ASSERT_TRUE(s.motion.move_velocity(X, 20'000, 5000));
  s.wait(1);
  EXPECT_NEAR(s.motion.velocity(X), 5000, 1e-6);
  EXPECT_FALSE(s.motion.move_velocity(X, 0, 100)) << "against its direction";
  s.wait(2);
  ASSERT_TRUE(s.motion.stop_at(X, 30'000));
  EXPECT_TRUE(s.motion.occupied(X));
  s.settle();
  EXPECT_EQ(s.motion.position(X), 30'000);
  EXPECT_EQ(s.count(What::rested), 1);
}

TEST(VmeStaircase, MmRunsTheOtherWay) {
  Stage s;
  s.motion.set_direction(X, Sign::minus);
  EXPECT_EQ(s.motion.direction(X), Sign::minus);
  EXPECT_FALSE(s.motion.move_velocity(X, 100, 1000));
  ASSERT_TRUE(s.motion.move_velocity(X, -100, 1000));
  s.wait(1);
  ASSERT_TRUE(s.motion.stop_at(X, -5000));
  s.settle();
  EXPECT_EQ(s.motion.position(X), -5000);
}

TEST(VmeStaircase, AStopTooNearIsSteeperAndExact) {
  Stage s;
  s.speeds(X, 1000, 1000);
  s.motion.jog(X, 1000);
  s.wait(2);
  const std::int64_t here = s.motion.position(X);
  ASSERT_TRUE(s.motion.stop_at(X, here + 100));
  s.settle();
  EXPECT_EQ(s.motion.position(X), here + 100) << "a ramp would have needed 500";
}

struct StopAt {
  double ac, jog, after_s;
  std::int64_t at;
  double rests_s;
};
TEST(VmeStaircase, AStopGoesToItsPlaceAtTheSpeedThatWasAskedFor) {
  // Right behind the jog, and while it still speeds up: v/a and the way at v; or a triangle.
  for (const StopAt& c : {StopAt{10'000, 500, 0, 1000, 2.05}, StopAt{10'000, -500, 0, -700, 1.45},
                          StopAt{10'000, 0.5, 0, 5, 10.00005}, StopAt{100, 1000, 0.1, 1000, 6.324555},
                          StopAt{10'000, 500, 0, 20, 0.089443}}) {
    Stage s;
    s.speeds(X, 200'000, c.ac);
    s.motion.jog(X, c.jog);
    s.wait(c.after_s);
    ASSERT_TRUE(s.motion.stop_at(X, c.at));
    EXPECT_TRUE(s.motion.occupied(X));
    s.settle();
    EXPECT_EQ(s.motion.position(X), c.at);
    ASSERT_NE(s.find(What::rested), nullptr) << c.at;
    EXPECT_NEAR(seconds(s.find(What::rested)->at.time_since_epoch()), c.rests_s, 2e-6);
  }
}

TEST(VmeStaircase, AStopWhileTheStepIsReachedTakesTheSpeedOfTheStep) {
  Stage s;
  s.speeds(X, 200'000, 100);
  s.motion.set_direction(X, Sign::plus);
  ASSERT_TRUE(s.motion.move_velocity(X, 1, 1000));
  s.wait(0.15);
  EXPECT_FALSE(s.motion.occupied(X));
  ASSERT_TRUE(s.motion.stop_at(X, 1000));
  s.settle();
  EXPECT_EQ(s.motion.position(X), 1000);
  EXPECT_NEAR(seconds(s.find(What::rested)->at.time_since_epoch()), 6.324555, 2e-6);
}

TEST(VmeStaircase, AStopAtAPlaceBehindComesToRestAndGoesBack) {
  for (const bool turning : {false, true}) {
    Stage s;
    s.speeds(X, 200'000, 10'000);
    s.motion.jog(X, 1000);
    s.wait(2);
    ASSERT_EQ(s.motion.position(X), 1950);
    if (turning) s.motion.jog(X, -1000);
    EXPECT_FALSE(s.motion.stop_at(X, position_max + 1));
    ASSERT_TRUE(s.motion.stop_at(X, 900));
    EXPECT_TRUE(s.motion.occupied(X));
    s.settle();
    EXPECT_EQ(s.motion.position(X), 900);
    EXPECT_EQ(s.motion.axis(X).span.highest, 2000) << "50 counts of ramp";
    EXPECT_EQ(s.motion.axis(X).span.travel, 2000 + 1100);
    EXPECT_EQ(s.count(What::rested), 1);
    EXPECT_NEAR(seconds(s.find(What::rested)->at.time_since_epoch()), 3.3, 2e-6) << "back at 1000/s, too";
  }
}

TEST(VmeStaircase, AStopTakesBackAWayBack) {
  Stage s;
  s.speeds(X, 200'000, 10'000);
  s.motion.jog(X, 1000);
  s.wait(2);
  ASSERT_TRUE(s.motion.stop_at(X, 900));
  s.motion.stop(X);
  s.settle();
  EXPECT_EQ(s.motion.position(X), 2000);
}

TEST(VmeStaircase, ACounterThatIsLoadedOnTheWayChangesTheWayAndNotTheSpeed) {
  Stage s;
  s.speeds(X, 200'000, 10'000);
  s.motion.jog(X, 500);
  ASSERT_TRUE(s.motion.stop_at(X, 1000));
  s.wait(1);
  s.motion.load_position(X, 0);
  s.wait(1);
  EXPECT_DOUBLE_EQ(s.motion.velocity(X), 500);
  s.settle();
  EXPECT_EQ(s.motion.position(X), 1000);
  EXPECT_NEAR(seconds(s.find(What::rested)->at.time_since_epoch()), 3.025, 0.003);
}

TEST(VmeStaircase, FpWhileTheMoveSpeedsUpGoesOnToTheSpeedOfTheMove) {
  Stage s;
  s.speeds(X, 1000, 100);
  s.move({{X, 5000}});
  s.wait(0.3);
  ASSERT_TRUE(s.motion.force_position(X, 1000));
  s.settle();
  EXPECT_EQ(s.motion.position(X), 1000);
  EXPECT_NEAR(seconds(s.find(What::rested)->at.time_since_epoch()), 6.324555, 2e-6);
  Stage at_once;
  at_once.speeds(X, 1000, 10'000);
  at_once.motion.jog(X, 500);
  ASSERT_TRUE(at_once.motion.force_position(X, 1000));
  at_once.settle();
  EXPECT_EQ(at_once.motion.position(X), 1000);
  EXPECT_NEAR(seconds(at_once.find(What::rested)->at.time_since_epoch()), 2.05, 2e-6);
}

TEST(VmeStaircase, FpTakesNoStopBack) {
  Stage s;
  s.speeds(X, 1000, 1000);
  s.motion.jog(X, 1000);
  s.wait(2);
  s.motion.stop(X);
  s.wait(0.9);
  ASSERT_TRUE(s.motion.force_position(X, 4000));
  s.settle();
  EXPECT_EQ(s.motion.position(X), 2000) << "500 counts of ramp from 1500";
  s.motion.jog(X, 1000);
  s.wait(2);
  s.motion.jog(X, -1000);
  ASSERT_TRUE(s.motion.force_position(X, 5000));
  s.settle();
  EXPECT_EQ(s.motion.position(X), 5000) << "and no jog behind it";
}

TEST(VmeStaircase, FpComesAsNearAsTheRampAllows) {
  Stage s;
  s.speeds(X, 1000, 1000);
  s.motion.jog(X, 1000);
  s.wait(2);
  ASSERT_TRUE(s.motion.force_position(X, 4000));
  s.settle();
  EXPECT_EQ(s.motion.position(X), 4000);
  s.motion.jog(X, 1000);
  s.wait(2);
  ASSERT_TRUE(s.motion.force_position(X, 5600));
  s.settle();
  EXPECT_EQ(s.motion.position(X), 6000) << "500 counts of ramp from 5500";
  s.move({{X, 20'000}});
  s.wait(2);
  ASSERT_TRUE(s.motion.force_position(X, 9000));
  s.settle();
  EXPECT_EQ(s.motion.position(X), 9000);
}

}  // namespace
}  // namespace hw::vme58
