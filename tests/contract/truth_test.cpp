// Moves, positions, homing and limits: what is said of them is what the emulated machine does, for every axis
// of every listed controller.
#include "tests/contract/truth.h"

#include <cmath>
#include <cstdlib>

namespace hw {
namespace {

using std::chrono::seconds;

INSTANTIATE_TEST_SUITE_P(Every, TruthTest, testing::ValuesIn(types_under_test()), name_of_type);

// ---- moves

TEST_P(TruthTest, EachAxisMovesItsOwnLoadAndNoOther) {
  for (int i = 0; i < axes(); ++i) {
    std::vector<Steps> before;
    for (int k = 0; k < axes(); ++k) before.push_back(load_of(k));
    const Steps distance(1000 + 100 * i);
    must(intent::MoveBy({{id(i), distance}}));
    ASSERT_TRUE(becomes_idle(seconds(30)));
    for (int k = 0; k < axes(); ++k) {
      const auto moved = (load_of(k) - before[static_cast<std::size_t>(k)]).value;
      if (k == i) {
        EXPECT_NEAR(static_cast<double>(moved), static_cast<double>(distance.value), 0.25 * 1100)
            << k << ": counts and pulses may differ, axes may not";
      } else {
        EXPECT_EQ(moved, 0) << "axis " << k << " moved with " << i;
      }
    }
    EXPECT_EQ(axis_at(i).position, distance);
    EXPECT_EQ(axis_at(i).ended_by, EndedBy::target);
  }
}

TEST_P(TruthTest, SeveralAxesGoToTheirPlacesAndBack) {
  const int last = axes() - 1;
  for (const std::int64_t there : {600, -500, -500}) {
    std::vector<AxisTarget> targets{{id(0), Steps(there)}};
    if (last > 0) targets.push_back({id(last), Steps(-2 * there)});
    must(intent::MoveTo(std::move(targets)));
    ASSERT_TRUE(becomes_idle(seconds(30)));
    EXPECT_EQ(axis().position, Steps(there));
    EXPECT_NEAR(static_cast<double>(load().value), static_cast<double>(there), 0.25 * 600);
    if (last == 0) continue;
    EXPECT_EQ(axis_at(last).position, Steps(-2 * there));
    EXPECT_NEAR(static_cast<double>(load_of(last).value), -2.0 * static_cast<double>(there), 0.25 * 1200);
  }
}

TEST_P(TruthTest, ADistanceInMinusGoesInMinus) {
  for (int i = 0; i < axes(); ++i) {
    must(intent::MoveBy({{id(i), Steps(-700)}}));
    ASSERT_TRUE(becomes_idle(seconds(30)));
    EXPECT_EQ(axis_at(i).position, Steps(-700));
    EXPECT_LT(load_of(i), Steps(-400));
  }
}

TEST_P(TruthTest, AMoveTakesTheTimeOfItsSpeed) {
  for (int i = 0; i < axes(); ++i)
    for (const double speed : {500.0, 1000.0}) {
      const Instant from = time.now();
      must(intent::MoveBy({{id(i), Steps(2000)}}, Pps{speed}));
      ASSERT_TRUE(
          run_until([&] { return !now().axis_moves(i) && time.now() - from > seconds(1); }, seconds(60)));
      const double took = std::chrono::duration<double>(time.now() - from).count();
      EXPECT_GE(took, 2000 / speed) << "axis " << i << " at " << speed;
      EXPECT_LE(took, 2000 / speed + 0.8) << "axis " << i << " at " << speed;
    }
}

TEST_P(TruthTest, AJogRunsItsWayAtItsSpeed) {
  for (int i = 0; i < axes(); ++i)
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const Steps from = load_of(i);
      must(intent::JogStart(id(i), sign, Pps{800}, false));
      run(seconds(3));
      const auto way = (load_of(i) - from).value;
      EXPECT_EQ(axis_at(i).direction, sign == Sign::plus ? 1 : -1);
      must(intent::Stop(i));
      ASSERT_TRUE(becomes_idle(seconds(20)));
      EXPECT_EQ(way > 0, sign == Sign::plus) << "axis " << i;
      EXPECT_NEAR(static_cast<double>(std::abs(way)), 2400, 0.3 * 2400) << "axis " << i;
    }
}

TEST_P(TruthTest, AbortStopsShorterThanStopAndEachReportsWhichItWas) {
  std::int64_t ran_on[2] = {0, 0};
  for (const bool at_once : {false, true}) {
    must(intent::MoveBy({{id(0), Steps(40000)}}, Pps{5000}));
    run(seconds(3));
    const Steps there = load();
    if (at_once)
      session->send(intent::Abort(0));
    else
      session->send(intent::Stop(0));
    ASSERT_TRUE(becomes_idle(seconds(30)));
    ran_on[at_once] = (load() - there).value;
    EXPECT_EQ(axis().ended_by, at_once ? EndedBy::abort : EndedBy::stop);
    EXPECT_LT(axis().position, Steps(40000 * (at_once ? 2 : 1)));
    must(intent::SetPosition(0));  // after an abort steps may be lost
  }
  EXPECT_GT(ran_on[false], ran_on[true]) << "a ramp takes its way";
}

TEST_P(TruthTest, AStopOfAllStopsWhicheverAxisMoves) {
  for (int i = 0; i < axes(); ++i) {
    must(intent::MoveBy({{id(i), Steps(40000)}}, Pps{1000}));
    run(seconds(1));
    session->send(intent::Stop());
    ASSERT_TRUE(becomes_idle(seconds(10))) << "axis " << i;
    EXPECT_EQ(axis_at(i).ended_by, EndedBy::stop) << "axis " << i;
  }
}

TEST_P(TruthTest, AStopOfAnAxisAtRestLeavesTheOtherToItsTarget) {
  if (axes() < 2) GTEST_SKIP() << "it has one axis";
  must(intent::MoveBy({{id(0), Steps(4000)}}, Pps{1000}));
  run(seconds(1));
  must(intent::Stop(axes() - 1));
  ASSERT_TRUE(becomes_idle(seconds(30)));
  EXPECT_EQ(axis().position, Steps(4000));
  EXPECT_EQ(axis().ended_by, EndedBy::target);
}

// ---- what a position is

TEST_P(TruthTest, ASetPositionIsTheControllersOwnFromThen) {
  for (int i = 0; i < axes(); ++i) {
    must(intent::MoveTo({{id(i), Steps(400)}}));
    ASSERT_TRUE(becomes_idle(seconds(20)));
    const Steps there = load_of(i);
    must(intent::SetPosition(i, Steps(0)));
    run(seconds(1));
    EXPECT_EQ(axis_at(i).position, Steps(0));
    EXPECT_EQ(load_of(i), there) << "setting it moves nothing";
    must(intent::MoveTo({{id(i), Steps(500)}}));
    ASSERT_TRUE(becomes_idle(seconds(20)));
    EXPECT_EQ(axis_at(i).position, Steps(500));
    EXPECT_GT(load_of(i), there + Steps(350)) << "axis " << i << " counts from what was set";
  }
}

TEST_P(TruthTest, APositionThatIsNotZeroIsSetOrRefused) {
  const IntentOutcome set = perform(intent::SetPosition(0, Steps(1234)));
  run(seconds(1));
  const Steps counts_from = set.state == IntentState::refused ? Steps(0) : Steps(1234);
  EXPECT_EQ(axis().position, counts_from);
  must(intent::MoveTo({{id(0), counts_from + Steps(400)}}));
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_NEAR(static_cast<double>(load().value), 400, 100);
}

// Read again after the link was lost: what the console remembers is not what counts.
TEST_P(TruthTest, PositionsAreReadAndNotRemembered) {
  must(intent::MoveTo({{id(0), Steps(900)}}));
  ASSERT_TRUE(becomes_idle(seconds(20)));
  must(intent::SetPosition(0));
  operate(bench::Unplug(true));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, seconds(10)));
  operate(bench::Unplug(false));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, seconds(30)));
  run(seconds(2));
  EXPECT_EQ(axis().position, Steps(0));
}

// ---- homing

struct HomedAt {
  Steps from, to;  ///< the load, in the direction of homing
};
/// By the names that modes have everywhere.
HomedAt place_of_mode(std::string_view mode, Sign sign) {
  if (mode.find("limit") != mode.npos) return {Steps(4000), Steps(5000)};
  if (mode == "index") return {Steps(600), Steps(800)};
  if (mode == "switch") return {sign == Sign::plus ? Steps(1000) : Steps(1000), Steps(5000)};
  return {Steps(900), Steps(2100)};  // from the edge of the switch to the end of the ramp behind it
}

TEST_P(TruthTest, EveryWayOfHomingEndsAtItsPlaceInItsDirection) {
  const auto modes = session->catalog().homing_modes;
  for (std::size_t mode = 0; mode < modes.size(); ++mode)
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      if (!modes[mode].allows(sign)) continue;
      reopen();
      AxisPlace travel;
      travel.minus = Steps(-5000);
      travel.plus = Steps(5000);
      travel.home_from = Steps(sign == Sign::plus ? 1000 : -1200);
      travel.home_to = Steps(sign == Sign::plus ? 1200 : -1000);
      travel.index_every = Steps(700);
      operate(bench::Place(id(0), travel));
      must(intent::Home(id(0), sign, static_cast<int>(mode)));
      run(Millis(50));
      const std::string what = fmt::format("{}{}", modes[mode].id, sign == Sign::plus ? "+" : "-");
      ASSERT_TRUE(becomes_idle(seconds(120))) << what;
      const std::int64_t homed = sign == Sign::plus ? load().value : -load().value;
      const HomedAt there = place_of_mode(modes[mode].id, sign);
      EXPECT_GE(homed, there.from.value) << what;
      EXPECT_LE(homed, there.to.value) << what;
      EXPECT_EQ(axis().ended_by, EndedBy::target) << what;
      EXPECT_NE(axis().activity, Activity::error) << what;
      run(seconds(1));
      const bool sets = modes[mode].sets_position;
      EXPECT_EQ(axis().trust.kind, sets ? Trust::homed : Trust::counted) << what;
      EXPECT_EQ(std::abs(axis().position.value) < 0.6 * static_cast<double>(homed), sets) << what;
    }
}

TEST_P(TruthTest, EachAxisFindsItsOwnHome) {
  const auto& modes = session->catalog().homing_modes;
  std::size_t mode = 0;
  while (!modes[mode].sets_position) ++mode;
  const HomedAt there = place_of_mode(modes[mode].id, Sign::minus);
  for (int i = 0; i < axes(); ++i) {
    AxisPlace travel;
    travel.minus = Steps(-5000);
    travel.home_from = Steps(-1200);
    travel.home_to = Steps(-1000);
    operate(bench::Place(id(i), travel));
    must(intent::Home(id(i), Sign::minus, static_cast<int>(mode)));
    run(Millis(50));
    ASSERT_TRUE(becomes_idle(seconds(120))) << i;
    run(seconds(1));
    EXPECT_LE(load_of(i), Steps(-there.from.value)) << i;
    EXPECT_GE(load_of(i), Steps(-there.to.value)) << i;
    EXPECT_EQ(axis_at(i).trust.kind, Trust::homed) << i;
    for (int k = i + 1; k < axes(); ++k) EXPECT_EQ(load_of(k), Steps(0)) << k << " moved with " << i;
  }
}

// ---- limits

TEST_P(TruthTest, ALimitIsReportedOnTheSideThatWasRunInto) {
  for (int i = 0; i < axes(); ++i)
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      reopen();
      const bool plus = sign == Sign::plus;
      place(i, Steps(-1500), Steps(1500));
      must(intent::MoveBy({{id(i), Steps(plus ? 6000 : -6000)}}));
      ASSERT_TRUE(becomes_idle(seconds(30)));
      run(seconds(2));
      const std::string what = fmt::format("axis {} {}", i, plus ? "+" : "-");
      ASSERT_TRUE(axis_at(i).limits_known) << what;
      EXPECT_EQ(axis_at(i).limit_plus, plus) << what;
      EXPECT_EQ(axis_at(i).limit_minus, !plus) << what;
      EXPECT_EQ(axis_at(i).ended_by, EndedBy::limit) << what;
      for (int k = 0; k < axes(); ++k)
        EXPECT_TRUE(k == i || !(axis_at(k).limit_plus || axis_at(k).limit_minus)) << what << ": at " << k;
    }
}

}  // namespace
}  // namespace hw
