// A plain step axis: where and when its motions end, and by what.
#include "core/motion/step_axis.h"

#include <gtest/gtest.h>

namespace hw::motion {
namespace {

const Ramp gentle(10'000, 10'000, Pps(400));

class StepAxisTest : public testing::Test {
 protected:
  void go(Sign sign, std::int64_t way, double speed = 1000) {
    axis.begin(now, sign, Profile::index(now, way, Pps(speed), gentle));
  }
  void home(Sign sign, StepAxis::Seeks seeks) {
    axis.begin(now, sign, Profile::constant(now, 0, Pps(400), Profile::endless), seeks);
  }
  void run(double seconds) { axis.advance(now += from_seconds(seconds)); }
  /// To its own next event.
  void run_to_event() {
    ASSERT_TRUE(axis.next_event());
    axis.advance(now = *axis.next_event());
  }
  void place_switches(std::int64_t minus, std::int64_t plus) {
    AxisPlace place;
    place.minus = Steps(minus), place.plus = Steps(plus);
    place.home_from = Steps(-20), place.home_to = Steps(-10);
    axis.plant.set_place(place);
  }
  StepAxis axis;
  Instant now{};
};

TEST_F(StepAxisTest, EndsAtItsTargetWhenItsProfileDoes) {
  go(Sign::minus, 250);
  EXPECT_EQ(axis.state(), StepAxis::State::moves);
  run_to_event();
  EXPECT_EQ(axis.state(), StepAxis::State::rests);
  EXPECT_EQ(axis.ended(), StepAxis::Ended::target);
  EXPECT_EQ(axis.position, Steps(-250));
  EXPECT_EQ(axis.plant.load(), Steps(-250));
  EXPECT_FALSE(axis.next_event()) << "nothing happens by itself at rest";
}

TEST_F(StepAxisTest, AMotionOfNoStepsEndsAtOnce) {
  go(Sign::plus, 0);
  EXPECT_EQ(axis.state(), StepAxis::State::rests);
  EXPECT_EQ(axis.ended(), StepAxis::Ended::target);
}

TEST_F(StepAxisTest, SlowsDownWithItsRampAndCountsEachStepOfIt) {
  go(Sign::plus, Profile::endless, 2000);
  run(1);
  const Steps at_the_stop = axis.position;
  axis.slow(now, 10'000);
  EXPECT_EQ(axis.state(), StepAxis::State::slows);
  axis.slow(now, 1);  // is slowing down already
  run_to_event();
  EXPECT_EQ(axis.ended(), StepAxis::Ended::stop);
  EXPECT_NEAR(static_cast<double>((axis.position - at_the_stop).value), 2000.0 * 2000 / (2 * 10'000), 2);
  EXPECT_EQ(axis.plant.load(), axis.position);
}

TEST_F(StepAxisTest, AKillEndsItOnTheSpot) {
  go(Sign::plus, Profile::endless, 2000);
  run(1);
  const Steps there = axis.position;
  axis.kill();
  run(1);
  EXPECT_EQ(axis.ended(), StepAxis::Ended::kill);
  EXPECT_EQ(axis.position, there);
  EXPECT_EQ(axis.speed(now).value, 0);
}

TEST_F(StepAxisTest, ALimitSwitchEndsIt) {
  place_switches(-100, 100);
  go(Sign::plus, 250);
  run(10);
  EXPECT_EQ(axis.ended(), StepAxis::Ended::limit);
  EXPECT_EQ(axis.position, Steps(100));
  go(Sign::plus, 1);
  EXPECT_EQ(axis.ended(), StepAxis::Ended::limit) << "it acts already";
  EXPECT_EQ(axis.position, Steps(100));
  go(Sign::minus, 50);
  run(10);
  EXPECT_EQ(axis.ended(), StepAxis::Ended::target) << "away from it";
}

TEST_F(StepAxisTest, ALimitSwitchEndsARampToo) {
  place_switches(-1000, 1000);
  go(Sign::plus, Profile::endless, 2000);
  while (axis.position < Steps(950)) run(0.001);
  axis.slow(now, 10'000);
  run(10);
  EXPECT_EQ(axis.ended(), StepAxis::Ended::limit);
  EXPECT_EQ(axis.position, Steps(1000));
}

TEST_F(StepAxisTest, AHandAtTheSwitchEndsAMotionUnderWay) {
  go(Sign::plus, Profile::endless);
  run(1);
  const Steps there = axis.position;
  axis.plant.operate_limit(Sign::minus, true);
  axis.plant_changed(), run(0);
  EXPECT_EQ(axis.state(), StepAxis::State::moves) << "it is behind the axis";
  axis.plant.operate_limit(Sign::plus, true);
  axis.plant_changed(), run(0);
  EXPECT_EQ(axis.ended(), StepAxis::Ended::limit);
  EXPECT_EQ(axis.position, there);
}

TEST_F(StepAxisTest, HomingCountsFromTheSwitchThatItSeeks) {
  place_switches(-100, 100);
  home(Sign::minus, StepAxis::Seeks::home_switch);
  run(10);
  EXPECT_EQ(axis.ended(), StepAxis::Ended::home);
  EXPECT_EQ(axis.position, Steps(0));
  EXPECT_EQ(axis.plant.load(), Steps(-10)) << "where the zone begins on its way";
  home(Sign::minus, StepAxis::Seeks::limit_switch);
  run(10);
  EXPECT_EQ(axis.ended(), StepAxis::Ended::home);
  EXPECT_EQ(axis.position, Steps(0));
  EXPECT_EQ(axis.plant.load(), Steps(-100));
}

TEST_F(StepAxisTest, HomingTheWrongWayEndsAtTheLimitAndKeepsTheCount) {
  place_switches(-100, 100);
  home(Sign::plus, StepAxis::Seeks::home_switch);
  run(10);
  EXPECT_EQ(axis.ended(), StepAxis::Ended::limit);
  EXPECT_EQ(axis.position, Steps(100));
}

TEST_F(StepAxisTest, AJammedLoadStaysBehindItsCount) {
  axis.plant.jam(true);
  go(Sign::plus, 250);
  run(10);
  EXPECT_EQ(axis.position, Steps(250));
  EXPECT_EQ(axis.plant.load(), Steps(0));
}

TEST_F(StepAxisTest, TheEarliestEventOfSeveralIsFound) {
  std::array<StepAxis, 3> axes;
  EXPECT_FALSE(next_event_of(axes));
  axes[1].begin(Instant{}, Sign::plus, Profile::index(Instant{}, 300, Pps(1000), gentle));
  axes[2].begin(Instant{}, Sign::plus, Profile::index(Instant{}, 200, Pps(1000), gentle));
  EXPECT_EQ(next_event_of(axes), axes[2].next_event());
}

}  // namespace
}  // namespace hw::motion
