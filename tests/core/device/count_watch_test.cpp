// A count that somebody else has set, told from motions, lost digits, slow rounds and restarts.
#include "core/device/count_watch.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

class CountWatchTest : public testing::Test {
 protected:
  void SetUp() override {
    catalog.axes.push_back({"X", "axis X"});
    catalog.jog_speed = Pps(1000);
    now.axis_count = 1;
    axis.position_known = true;
    axis.activity = Activity::idle;
    axis.own_speed = Pps(1000);
    reads(5000, 4);
  }
  /// Rounds of so long; what they have told in all.
  std::uint32_t reads(std::int64_t place, int rounds = 1, Duration each = Millis(200)) {
    std::uint32_t reported = 0;
    for (int n = 0; n < rounds; ++n) {
      axis.seen_at += each;
      axis.position = Steps(place);
      reported |= watch.look(now);
    }
    return reported;
  }
  Catalog catalog;
  Snapshot now;
  AxisState& axis = now.axes[0];
  CountWatch watch{catalog};
};

TEST_F(CountWatchTest, ReportsOnceThatItWasSet) {
  EXPECT_EQ(reads(0, 3), 0u) << "what explains it may show yet";
  EXPECT_EQ(reads(0, 10), 1u);
  EXPECT_EQ(reads(0, 10), 0u);
}

TEST_F(CountWatchTest, ADigitLostOnTheWayIsNoCount) {
  EXPECT_EQ(reads(500), 0u);
  EXPECT_EQ(reads(5000, 20), 0u);
  EXPECT_EQ(reads(500, 2), 0u);
  EXPECT_EQ(reads(5000, 20), 0u);
}

TEST_F(CountWatchTest, AnUnseenMotionMovesNoFartherThanItsSpeedAllows) {
  EXPECT_EQ(reads(5200, 20), 0u);
  EXPECT_EQ(reads(5400), 0u);
  EXPECT_EQ(reads(5600), 0u);
  EXPECT_EQ(reads(5800, 20), 0u) << "three short ones in a row";
}

TEST_F(CountWatchTest, ASlowRoundLeavesTimeForALongMotion) {
  EXPECT_EQ(reads(9000, 1, std::chrono::seconds(4)), 0u);
  EXPECT_EQ(reads(9000, 20), 0u);
}

TEST_F(CountWatchTest, ASentCommandExplainsAChangedCount) {
  watch.disturbed();
  EXPECT_EQ(reads(0, 20), 0u);
}

TEST_F(CountWatchTest, SoDoAHomeSearchAProgramARestartAndAMissingAnswer) {
  const auto explained = [&](auto change, auto back) {
    watch.disturbed();
    reads(5000, 5);
    change();
    reads(5000);
    back();
    return reads(0, 20) == 0;
  };
  EXPECT_TRUE(explained([&] { axis.activity = Activity::homing; }, [&] { axis.activity = Activity::idle; }));
  EXPECT_TRUE(explained([&] { now.program.owned = true, now.program.run = RunState::running; },
                        [&] { now.program.run = RunState::idle; }));
  EXPECT_TRUE(explained([&] { ++now.restarts; }, [] {}));
  EXPECT_TRUE(explained([&] { ++now.link.timeouts; }, [] {}));
}

TEST_F(CountWatchTest, AnAxisIsWatchedWhileAnotherMoves) {
  catalog.axes.push_back({"Y", "axis Y"});
  now.axis_count = 2;
  now.axes[1].activity = Activity::jogging;
  now.axes[1].position_known = true;
  EXPECT_EQ(reads(0, 10), 1u);
}

/// Its own speed is 1000 a second, as told.
class CountWatchInAJog : public CountWatchTest {
 protected:
  void SetUp() override {
    CountWatchTest::SetUp();
    catalog.jog_speed_max = Pps(6000);
    axis.activity = Activity::jogging;
    axis.speed = Pps(1000);
    for (at = 5200; at < 6200; at += 200) EXPECT_EQ(reads(at), 0u);
  }
  std::int64_t at = 5200;
};

TEST_F(CountWatchInAJog, ACountThatIsSetIsReportedWhileTheJogGoesOn) {
  std::uint32_t reported = 0;
  for (std::int64_t place = 0; place < 2000; place += 200) reported |= reads(place);
  EXPECT_EQ(reported, 1u);
}

TEST_F(CountWatchInAJog, AndBehindItWhereItEndsAtOnce) {
  EXPECT_EQ(reads(0), 0u);
  axis.activity = Activity::idle;
  EXPECT_EQ(reads(100, 10), 1u);
}

TEST_F(CountWatchInAJog, ItsOwnWayIsNone) {
  for (; at < 12'000; at += 200) EXPECT_EQ(reads(at), 0u);
  axis.activity = Activity::stopping, axis.speed = {};
  EXPECT_EQ(reads(at + 150), 0u);
  axis.activity = Activity::idle;
  EXPECT_EQ(reads(at + 180, 20), 0u);
}

TEST_F(CountWatchInAJog, OfAJogAtTheControllerNoSpeedIsKnown) {
  axis.speed = {};
  for (; at < 12'000; at += 1100) EXPECT_EQ(reads(at), 0u);
  axis.activity = Activity::idle;
  EXPECT_EQ(reads(at, 20), 0u);
}

TEST_F(CountWatchTest, AMotionThatShowsInPlacesOnlyIsNone) {
  catalog.jog_speed_max = Pps(6000);
  std::int64_t at = 5000;
  for (; at < 9000; at += 1000) EXPECT_EQ(reads(at), 0u) << "a VXM tells of no motion but its own";
  EXPECT_EQ(reads(at, 20), 0u);
}

TEST_F(CountWatchTest, ASpoiltReadingBehindACountThatIsSetHidesNothing) {
  EXPECT_EQ(reads(200), 0u);
  EXPECT_EQ(reads(900), 0u) << "spoilt";
  EXPECT_EQ(reads(200, 10), 1u);
}

/// A move from 5000 to 9000 at 1000 a second, looked at five times a second.
class CountWatchInFlight : public CountWatchTest {
 protected:
  void SetUp() override {
    CountWatchTest::SetUp();
    axis.activity = Activity::moving;
    axis.has_target = true;
    axis.target = Steps(9000);
    axis.speed = Pps(1000);
    for (; at < 6000; at += 200) EXPECT_EQ(reads(at), 0u);
  }
  std::int64_t at = 5000;
};

TEST_F(CountWatchInFlight, ACountThatIsSetDuringAMoveIsReported) {
  std::uint32_t reported = 0;
  for (std::int64_t place = 0; place < 2000; place += 200) reported |= reads(place);
  EXPECT_EQ(reported, 1u);
}

TEST_F(CountWatchInFlight, ASmallLeapIsReportedInBothDirections) {
  for (const int leap : {-300, -700, 400, 700}) {
    watch.disturbed();
    for (at = 5000; at < 6000; at += 200) EXPECT_EQ(reads(at), 0u);
    EXPECT_EQ(reads(at + leap, 1), 0u) << "it may be spoilt";
    std::uint32_t reported = 0;
    for (at += 200; at < 7400; at += 200) reported |= reads(at + leap);
    EXPECT_EQ(reported, 1u) << leap;
  }
}

TEST_F(CountWatchInFlight, AMoveThatIsTurnedRoundIsNone) {
  for (; at > 2000; at -= 200) EXPECT_EQ(reads(at), 0u) << "by another program";
  EXPECT_EQ(reads(at, 3), 0u);
}

TEST_F(CountWatchInFlight, OneSpoiltReadingAsItSlowsDownIsNone) {
  const std::int64_t places[] = {6000, 5700, 6340, 6480, 6600, 6700, 6780, 6840, 6880, 6900, 6900, 6900};
  for (const std::int64_t place : places) EXPECT_EQ(reads(place), 0u) << place;
}

TEST_F(CountWatchInFlight, TheMoveItselfIsNone) {
  for (; at < 9000; at += 200) EXPECT_EQ(reads(at), 0u);
  EXPECT_EQ(reads(9000, 5), 0u);
  axis.activity = Activity::idle, axis.has_target = false;
  EXPECT_EQ(reads(9000, 20), 0u);
}

TEST_F(CountWatchInFlight, SpoiltReadingsAreNone) {
  for (; at < 9000; at += 400) {
    EXPECT_EQ(reads(at % 1000), 0u) << "its first digit was lost";
    EXPECT_EQ(reads(at + 200), 0u);
  }
}

TEST_F(CountWatchInFlight, AHomeSearchOrAProgramMaySetIt) {
  axis.activity = Activity::homing;
  EXPECT_EQ(reads(0, 20), 0u);
  axis.activity = Activity::moving;
  now.program.run = RunState::running, now.program.owned = true;
  EXPECT_EQ(reads(5000, 20), 0u);
}

TEST_F(CountWatchTest, TheEncoderOfAFreeMotorMayBeTurnedByHand) {
  axis.in_counts = true, axis.enabled = false;
  EXPECT_EQ(reads(0, 20), 0u);
  axis.in_counts = false;
  axis.loop = Loop::open;
  EXPECT_EQ(reads(5000, 20), 0u);
}

TEST_F(CountWatchTest, ACounterThatGoesOnFromItsOtherEndIsNotSet) {
  catalog.position_min = Steps(-10'000), catalog.position_max = Steps(10'000);
  watch.disturbed();
  EXPECT_EQ(reads(9900, 5), 0u);
  EXPECT_EQ(reads(-9900, 20), 0u);
  EXPECT_EQ(reads(-2000, 20), 1u) << "not half of its range";
}

TEST_F(CountWatchTest, AnAxisThatStopsOutOfItsHomeSearchMayBeSet) {
  axis.activity = Activity::homing;
  EXPECT_EQ(reads(5200), 0u);
  watch.disturbed();
  axis.activity = Activity::stopping;
  EXPECT_EQ(reads(5400, 5), 0u);
  EXPECT_EQ(reads(0, 20), 0u);
  axis.activity = Activity::idle;
  EXPECT_EQ(reads(0, 20), 0u);
  EXPECT_EQ(reads(5000, 20), 1u) << "it is watched again";
}

TEST_F(CountWatchTest, AnEncoderMayCountFasterThanTheMotorIsPulsed) {
  catalog.jog_speed_max = Pps(6000);
  axis.in_counts = true;
  EXPECT_EQ(reads(5000, 5), 0u);
  EXPECT_EQ(reads(6500, 20), 0u) << "1000 pulses a second may be more counts";
}

TEST_F(CountWatchTest, TheEncoderCountOfAHeldMotorIsWatched) {
  axis.in_counts = true;
  EXPECT_EQ(reads(5000, 5), 0u) << "other units are no other count";
  EXPECT_EQ(reads(0, 10), 1u);
}

}  // namespace
}  // namespace hw
