// Where the axes have been is told as far as it was known.
#include "gui/model/position_trace.h"

#include <gtest/gtest.h>

namespace hw::gui {
namespace {

struct PositionTraceTest : testing::Test {
  PositionTraceTest() {
    now.link.state = LinkState::good;
    now.axis_count = 2;
    for (AxisState& a : now.axes) a.position_known = true;
    at(0, 0);
  }
  void at(int x, int y) {
    now.axes[0].position = Steps(x), now.axes[1].position = Steps(y);
    trace.follow(now);
  }
  Snapshot now;
  PositionTrace trace;
};

TEST_F(PositionTraceTest, GrowsOnlyWhileSomethingMoves) {
  at(5, 0), at(5, 0), at(5, 7);
  ASSERT_EQ(trace.places().size(), 3u);
  const auto count = trace.count();
  at(5, 7);
  EXPECT_EQ(trace.count(), count);
  EXPECT_FALSE(trace.places()[0].goes_on);
  EXPECT_TRUE(trace.places()[2].goes_on);
}

TEST_F(PositionTraceTest, KnowsHowLongItRestedWhereItIs) {
  now.at = Instant(Millis(100));
  at(5, 0);
  now.at = Instant(Millis(900));
  at(5, 0);
  EXPECT_EQ(trace.places().back().at, Instant(Millis(100)));
  EXPECT_EQ(trace.places().back().until, Instant(Millis(900)));
  EXPECT_EQ(trace.first_at(), Instant{});
  trace.clear();
  at(5, 0);
  EXPECT_EQ(trace.first_at(), Instant(Millis(900)));
}

TEST_F(PositionTraceTest, ALostLinkLeavesAGap) {
  at(5, 0);
  now.link.state = LinkState::lost;
  at(6, 0);
  now.link.state = LinkState::good;
  at(900, 0);
  ASSERT_EQ(trace.places().size(), 3u);
  EXPECT_FALSE(trace.places()[2].goes_on) << "nobody saw how it came there";
}

TEST_F(PositionTraceTest, ACountThatMayNotBeTrueLeavesNoTrace) {
  now.axes[1].trust.doubt(Doubt::power_cut, Instant(Millis(5)));
  at(40, 0);
  EXPECT_EQ(trace.places().size(), 1u);
  now.axes[1].trust.settle(Trust::homed, Instant(Millis(9)));
  at(0, 0);
  ASSERT_EQ(trace.places().size(), 2u);
  EXPECT_FALSE(trace.places()[1].goes_on);
}

TEST_F(PositionTraceTest, ACountThatIsSetAnewIsNoWay) {
  at(5, 0);
  now.axes[0].trust.settle(Trust::set, Instant(Millis(9)));
  at(1000, 0);
  EXPECT_FALSE(trace.places().back().goes_on);
  at(1001, 0);
  EXPECT_TRUE(trace.places().back().goes_on);
}

TEST_F(PositionTraceTest, ALimitIsWhereItsSwitchBeganToAct) {
  now.axes[0].limits_known = true;
  EXPECT_FALSE(trace.met(AxisId{0}).plus);
  at(400, 0);
  now.axes[0].limit_plus = true;
  at(410, 0), at(425, 0);
  now.axes[0].limit_plus = false;
  at(300, 0);
  EXPECT_EQ(trace.met(AxisId{0}).plus, Steps(410));
  EXPECT_FALSE(trace.met(AxisId{0}).minus);
  EXPECT_FALSE(trace.met(AxisId{1}).plus);
  now.axes[0].trust.settle(Trust::set, Instant(Millis(9)));
  at(0, 0);
  EXPECT_FALSE(trace.met(AxisId{0}).plus) << "the count is another one";
}

TEST_F(PositionTraceTest, HomeIsWhereAHomingHasEnded) {
  now.axes[1].activity = Activity::homing;
  at(0, -70);
  now.axes[1].activity = Activity::idle;
  now.axes[1].ended_by = EndedBy::stop;
  at(0, -80);
  EXPECT_FALSE(trace.met(AxisId{1}).home) << "it was stopped on the way";
  now.axes[1].activity = Activity::homing;
  at(0, -90);
  now.axes[1].activity = Activity::idle;
  now.axes[1].ended_by = EndedBy::target;
  now.axes[1].trust.settle(Trust::homed, Instant(Millis(9)));
  at(0, 0);
  EXPECT_EQ(trace.met(AxisId{1}).home, Steps(0));
}

}  // namespace
}  // namespace hw::gui
