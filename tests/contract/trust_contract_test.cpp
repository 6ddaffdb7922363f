// What every controller does with an axis of which it is known that it may stand elsewhere than it counts.
#include <map>

#include "tests/contract/another_host.h"
#include "tests/contract/rig.h"

namespace hw {
namespace {

using std::chrono::seconds;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class TrustContract : public ContractTest {
 protected:
  static constexpr Pps slow{1000};
  /// It stands at `there` and counts from 0 there.
  void lose_power_at(Steps there) {
    ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, there}})).state, IntentState::done);
    ASSERT_TRUE(becomes_idle(seconds(60)));
    perform(intent::Stop());  // which keeps nothing back afterwards
    lose_power();
  }
  void lose_power() {
    operate(bench::PowerCycle());
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good && now().restarts == 1; },
                          seconds(60)));
    run(seconds(2));
    ASSERT_TRUE(axis().trust.doubtful());
    EXPECT_EQ(now().restarts, 1u) << "it is told once";
  }
  /// As a user does before the first move.
  void switch_motor_on() {
    if (session->catalog().axes[0].switchable) perform(intent::SetPower(0, true));
    run(seconds(1));
  }
  void jog_at(Pps speed, Duration time_to_run) {
    EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, speed, false)).state, IntentState::done);
    run(time_to_run);
    ASSERT_GT(axis().position, Steps(100));
  }
  void another_sends(std::string_view bytes) {
    send_as_another(
        io, *session, [this](Duration d) { run(d); }, std::string(bytes));
  }
  /// Where no motion of a fifth of a second reaches; its encoder counts nothing there.
  void stand_far_out() {
    switch_motor_on();
    if (session->catalog().find_param("SL") >= 0) perform(intent::SetParam("SL", 0));
    const bool fast = session->catalog().can.window;
    ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(fast ? 90'000 : 4'000)}})).state, IntentState::done);
    ASSERT_TRUE(becomes_idle(seconds(120)));
    run(seconds(3));
    ASSERT_FALSE(axis().trust.doubtful());
  }
  IntentOutcome go_to(std::int64_t place, bool despite_doubt = false) {
    intent::MoveTo go({{AxisId{0}, Steps(place)}});
    go.despite_doubt = despite_doubt;
    const IntentOutcome outcome = perform(std::move(go));
    EXPECT_TRUE(becomes_idle(seconds(60)));
    return outcome;
  }
};

INSTANTIATE_TEST_SUITE_P(Every, TrustContract, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(TrustContract, AfterAPowerCycleNothingGoesToAPlaceByItsCount) {
  ASSERT_NO_FATAL_FAILURE(lose_power_at(Steps(500)));
  EXPECT_EQ(now().axes[0].trust.kind, Trust::untrusted);
  const Steps stood = load();
  const IntentOutcome refused = go_to(240);
  EXPECT_EQ(refused.state, IntentState::refused);
  EXPECT_EQ(refused.doubtful, 1u);
  EXPECT_THAT(std::string(refused.sentence.view()),
              AllOf(StartsWith("The position of "), HasSubstr(" cannot be trusted: its power was cut"),
                    HasSubstr(". 240 "),
                    HasSubstr(" may differ from before. Nothing was sent. Home it, set its position, or go "
                              "on just this once.")));
  EXPECT_EQ(load(), stood);
  EXPECT_EQ(axis().position, Steps(0));
}

TEST_P(TrustContract, APowerCycleWhereItCountsZeroShows) {
  switch_motor_on();
  ASSERT_NO_FATAL_FAILURE(lose_power());
  EXPECT_EQ(go_to(240).state, IntentState::refused);
}

TEST_P(TrustContract, APowerCycleInTheMiddleOfAMoveShows) {
  switch_motor_on();
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(90'000)}}, slow)).state, IntentState::done);
  run(seconds(1));
  ASSERT_GT(axis().position, Steps(100));
  ASSERT_NO_FATAL_FAILURE(lose_power());
  EXPECT_EQ(axis().ended_by, EndedBy::lost);
  EXPECT_EQ(go_to(240).state, IntentState::refused);
}

TEST_P(TrustContract, APowerCycleOnTheWayToZeroShows) {
  switch_motor_on();
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(4'000)}})).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(seconds(60)));
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(0)}}, slow)).state, IntentState::done);
  run(seconds(1));
  ASSERT_TRUE(now().any_axis_moving());
  ASSERT_NO_FATAL_FAILURE(lose_power());
  EXPECT_EQ(go_to(240).state, IntentState::refused);
}

TEST_P(TrustContract, APowerCycleRightBehindTheEndOfAMoveShows) {
  switch_motor_on();
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(0)}})).state, IntentState::done);
  ASSERT_NO_FATAL_FAILURE(lose_power());
  EXPECT_EQ(go_to(240).state, IntentState::refused);
}

TEST_P(TrustContract, APowerCycleWhileItJogsShows) {
  switch_motor_on();
  ASSERT_NO_FATAL_FAILURE(jog_at(slow, seconds(3)));
  ASSERT_NO_FATAL_FAILURE(lose_power());
  EXPECT_EQ(go_to(240).state, IntentState::refused);
}

TEST_P(TrustContract, APowerCycleWhileItIsBeingStoppedShows) {
  switch_motor_on();
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(90'000)}}, slow)).state, IntentState::done);
  run(seconds(3));
  session->send(intent::Stop());
  run(Millis(30));
  ASSERT_NO_FATAL_FAILURE(lose_power());
  EXPECT_EQ(go_to(240).state, IntentState::refused);
}

TEST_P(TrustContract, MovesByDistanceAndJogsNeedNoTrustedCount) {
  ASSERT_NO_FATAL_FAILURE(lose_power_at(Steps(500)));
  EXPECT_EQ(perform(intent::MoveBy({{AxisId{0}, Steps(100)}})).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_EQ(axis().position, Steps(100));
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus)).state, IntentState::done);
  run(Millis(200));
  EXPECT_EQ(perform(intent::JogStop()).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_GT(axis().position, Steps(100));
  EXPECT_TRUE(axis().trust.doubtful()) << "a distance tells nothing of the place";
}

TEST_P(TrustContract, OnceIsOnce) {
  ASSERT_NO_FATAL_FAILURE(lose_power_at(Steps(500)));
  EXPECT_EQ(go_to(240, true).state, IntentState::done);
  EXPECT_EQ(axis().position, Steps(240));
  EXPECT_EQ(go_to(0).state, IntentState::refused);
  EXPECT_EQ(axis().position, Steps(240));
}

TEST_P(TrustContract, OnTheUsersWordItIsTrustedAsItReads) {
  ASSERT_NO_FATAL_FAILURE(lose_power_at(Steps(500)));
  session->traffic().drain([](const TrafficEntry&) {});
  EXPECT_EQ(perform(intent::TrustPosition(AxisId{0})).state, IntentState::done);
  session->traffic().drain([](const TrafficEntry& e) {
    EXPECT_TRUE(e.way == Way::received || e.kind == TrafficKind::poll)
        << "nothing is sent for it: " << e.bytes;
  });
  EXPECT_EQ(axis().trust.kind, Trust::set);
  EXPECT_EQ(go_to(240).state, IntentState::done);
  EXPECT_EQ(axis().position, Steps(240));
}

TEST_P(TrustContract, ZeroWhereTheLastSessionLeftItElsewhereIsNotTrusted) {
  const KeptPosition kept{true, Steps(900), {Trust::homed, Doubt::none, Instant{}}};
  EXPECT_EQ(perform(intent::RecallPositions({kept})).state, IntentState::done);
  EXPECT_EQ(axis().trust.cause, Doubt::zero_since);
  EXPECT_EQ(go_to(240).state, IntentState::refused);
}

TEST_P(TrustContract, KeptPositionsAreUsedWhereTheControllerKnowsNone) {
  switch_motor_on();
  ASSERT_EQ(go_to(500).state, IntentState::done);
  const KeptPosition kept{true, Steps(500), {Trust::homed, Doubt::none, Instant{}}};
  EXPECT_EQ(perform(intent::RecallPositions({kept})).state, IntentState::done);
  EXPECT_TRUE(axis().trust.restored);
  EXPECT_EQ(axis().trust.kind, Trust::homed);
  EXPECT_EQ(perform(intent::SetPosition(0)).state, IntentState::done);
  EXPECT_EQ(perform(intent::RecallPositions({kept})).state, IntentState::done);
  EXPECT_EQ(axis().trust.kind, Trust::set) << "somebody has said it since";
  EXPECT_FALSE(axis().trust.restored);
}

TEST_P(TrustContract, WhereItStandsCanBeSet) {
  ASSERT_NO_FATAL_FAILURE(lose_power_at(Steps(500)));
  EXPECT_EQ(perform(intent::SetPosition(0)).state, IntentState::done);
  EXPECT_EQ(axis().trust.kind, Trust::set);
  EXPECT_EQ(go_to(240).state, IntentState::done);
}

TEST_P(TrustContract, ItsHomeMakesItTrustedWhereThatSetsTheCount) {
  AxisPlace place;
  place.minus = Steps(-6000);
  place.home_from = Steps(-900);
  place.home_to = Steps(-600);
  operate(bench::Place(AxisId{0}, place));
  ASSERT_NO_FATAL_FAILURE(lose_power_at(Steps(500)));
  const auto& modes = session->catalog().homing_modes;
  int mode = 0;
  while (!modes[static_cast<std::size_t>(mode)].sets_position) ++mode;
  EXPECT_EQ(perform(intent::Home(AxisId{0}, Sign::minus, mode)).state, IntentState::done);
  EXPECT_TRUE(run_until([this] { return axis().trust.kind == Trust::homed; }, seconds(60)));
  ASSERT_TRUE(becomes_idle(seconds(60)));
  EXPECT_EQ(go_to(240).state, IntentState::done);
}

TEST_P(TrustContract, AProgramThatGoesToAPlaceIsNotStartedByItsCount) {
  if (!GetParam()->language) GTEST_SKIP() << "it has no programs";
  struct Texts {
    const char *to_a_place, *by_a_distance;
  };
  const std::map<std::string_view, Texts> texts{
      {"vxm", {"IA1M240\n", "I1M40\n"}},
      {"pmx-4ex-sa", {"X240\nWAITX\nEND\n", "INC\nX40\nWAITX\nEND\n"}},
      {"dmx-k-sa", {"X240\nWAITX\nEND\n", "INC\nX40\nWAITX\nEND\n"}},
      {"vme58", {"AA;\nMA240; GO ID\n", "AA;\nMR40; GO ID\n"}}};
  const Texts& text = texts.at(GetParam()->model);
  ASSERT_NO_FATAL_FAILURE(lose_power_at(Steps(500)));
  switch_motor_on();
  ASSERT_EQ(perform(intent::LoadProgram(0, text.to_a_place), seconds(60)).state, IntentState::done);
  const Steps stood = load();
  const IntentOutcome refused = perform(intent::RunProgram(0), seconds(20));
  EXPECT_EQ(refused.state, IntentState::refused);
  EXPECT_EQ(refused.doubtful, 1u);
  EXPECT_THAT(std::string(refused.sentence.view()),
              HasSubstr("Nothing was sent. Home it, set its position, or"));
  run(seconds(2));
  EXPECT_EQ(load(), stood);
  intent::RunProgram once(0);
  once.despite_doubt = true;
  EXPECT_EQ(perform(std::move(once), seconds(20)).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(seconds(60)));
  EXPECT_EQ(axis().position, Steps(240));
  ASSERT_EQ(perform(intent::LoadProgram(0, text.by_a_distance), seconds(60)).state, IntentState::done);
  const IntentOutcome relative = perform(intent::RunProgram(0), seconds(20));
  EXPECT_EQ(relative.state, IntentState::done) << relative.sentence.view();
  ASSERT_TRUE(becomes_idle(seconds(60)));
  EXPECT_EQ(axis().position, Steps(280));
}

TEST_P(TrustContract, ACountThatAnotherProgramHasSetIsNotTrusted) {
  ASSERT_NO_FATAL_FAILURE(stand_far_out());
  another_sends(wire_texts(GetParam()->model).zero);
  run(seconds(4));
  ASSERT_EQ(axis().position, Steps(0));
  EXPECT_EQ(axis().trust.kind, Trust::untrusted);
  const IntentOutcome refused = go_to(240);
  EXPECT_EQ(refused.state, IntentState::refused);
  EXPECT_EQ(axis().position, Steps(0));
  EXPECT_EQ(now().restarts, 0u);
  EXPECT_THAT(std::string(refused.sentence.view()),
              HasSubstr("its count was changed by another program or at the controller"));
  EXPECT_EQ(perform(intent::TrustPosition(AxisId{0})).state, IntentState::done);
  EXPECT_EQ(go_to(240).state, IntentState::done);
  EXPECT_FALSE(axis().trust.doubtful());
}

TEST_P(TrustContract, TheCountOfAClosedLoopIsWatchedToo) {
  const std::map<std::string_view, std::pair<const char*, const char*>> loops{
      {"pmx-4ex-sa", {"SLX", "@00EX=90000\r"}}, {"dmx-k-sa", {"SL", "@00PX=90000\r"}}};
  const auto loop = loops.find(GetParam()->model);
  if (loop == loops.end()) GTEST_SKIP() << "it has no StepNLoop";
  switch_motor_on();
  ASSERT_EQ(perform(intent::SetParam(loop->second.first, 1)).state, IntentState::done);
  run(seconds(3));
  ASSERT_TRUE(axis().in_counts);
  another_sends(loop->second.second);
  run(seconds(4));
  EXPECT_TRUE(axis().trust.doubtful()) << axis().position.value;
}

TEST_P(TrustContract, AMoveOfAnotherProgramLeavesItsCountTrue) {
  ASSERT_NO_FATAL_FAILURE(stand_far_out());
  const Steps before = axis().position;
  another_sends(wire_texts(GetParam()->model).short_move);
  run(seconds(4));
  EXPECT_EQ(axis().position, before + Steps(100));
  EXPECT_FALSE(axis().trust.doubtful());
}

TEST_P(TrustContract, NorDoesItsOwnCommandThatSetsIt) {
  ASSERT_NO_FATAL_FAILURE(stand_far_out());
  EXPECT_EQ(perform(intent::SetPosition(0)).state, IntentState::done);
  run(seconds(4));
  EXPECT_EQ(axis().position, Steps(0));
  EXPECT_EQ(axis().trust.kind, Trust::set);
}

// From a speed at which a step motor overshoots.
TEST_P(TrustContract, AStopWithoutARampFromFullSpeedIsDoubted) {
  if (session->catalog().axes[0].servo) GTEST_SKIP() << "its encoder tells";
  if (session->catalog().find_param("SL") >= 0)
    perform(intent::SetParam("SL", 0));  // else the encoder counts
  ASSERT_NO_FATAL_FAILURE(jog_at(Pps(4000), seconds(5)));
  ASSERT_GT(axis().speed.value, 3000);
  perform(intent::Abort());
  ASSERT_TRUE(becomes_idle(seconds(60)));
  EXPECT_EQ(axis().trust.cause, Doubt::killed);
  EXPECT_EQ(go_to(240).state, IntentState::refused);
}

TEST_P(TrustContract, AStopWithItsRampIsNot) {
  ASSERT_NO_FATAL_FAILURE(jog_at(Pps(4000), seconds(5)));
  perform(intent::Stop());
  ASSERT_TRUE(becomes_idle(seconds(60)));
  EXPECT_EQ(axis().trust.kind, Trust::counted);
}

TEST_P(TrustContract, AFreshConnectionCounts) {
  EXPECT_EQ(axis().trust.kind, Trust::counted);
  EXPECT_EQ(go_to(240).state, IntentState::done);
}

}  // namespace
}  // namespace hw
