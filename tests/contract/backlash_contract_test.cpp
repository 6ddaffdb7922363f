// Backlash on every controller: whatever way a move comes from, it ends the way that was chosen.
#include "tests/contract/another_host.h"
#include "tests/contract/rig.h"

namespace hw {
namespace {

using std::chrono::seconds;

class BacklashContract : public ContractTest {
 protected:
  void SetUp() override {
    ContractTest::SetUp();
    if (session->catalog().axes[0].switchable) perform(intent::SetPower(0, true));
    run(seconds(1));
    ASSERT_EQ(perform(intent::SetBacklash(AxisId{0}, {Steps(60), Sign::plus})).state, IntentState::done);
  }
  /// Where it was at its lowest on the way; it ends at `place`.
  std::int64_t lowest_on_the_way(IntentBody body, std::int64_t place) {
    std::int64_t lowest = axis().commanded().value;
    EXPECT_EQ(perform(std::move(body)).state, IntentState::done);
    EXPECT_TRUE(run_until(
        [&] {
          lowest = std::min(lowest, axis().commanded().value);
          return !now().pieces.running && !now().any_axis_moving() &&
                 now().axes[0].commanded().value == place;
        },
        seconds(60)));
    EXPECT_EQ(axis().commanded().value, place);
    return lowest;
  }
  IntentBody to(std::int64_t place) { return intent::MoveTo({{AxisId{0}, Steps(place)}}); }
  IntentBody by(std::int64_t way) { return intent::MoveBy({{AxisId{0}, Steps(way)}}); }
};

INSTANTIATE_TEST_SUITE_P(Every, BacklashContract, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(BacklashContract, AMoveThatEndsTheOtherWayGoesPastItsTargetAndComesBack) {
  EXPECT_GE(lowest_on_the_way(to(800), 800), 0);
  EXPECT_NEAR(static_cast<double>(lowest_on_the_way(to(300), 300)), 240, 3);
  EXPECT_NEAR(static_cast<double>(lowest_on_the_way(by(-100), 200)), 140, 3);
  EXPECT_GE(lowest_on_the_way(by(100), 300), 200);
}

TEST_P(BacklashContract, AStopDropsTheWayBack) {
  lowest_on_the_way(to(800), 800);
  EXPECT_EQ(perform(to(300)).state, IntentState::done);
  run(Millis(100));
  perform(intent::Stop());
  ASSERT_TRUE(becomes_idle(seconds(20)));
  run(seconds(1));
  EXPECT_FALSE(now().pieces.running);
  EXPECT_FALSE(now().any_axis_moving());
  EXPECT_NE(axis().commanded(), Steps(300));
}

TEST_P(BacklashContract, AQuestionInBetweenLeavesTheWayBackToCome) {
  const WireTexts& text = wire_texts(GetParam()->model);
  lowest_on_the_way(to(800), 800);
  EXPECT_EQ(perform(to(300)).state, IntentState::done);
  EXPECT_EQ(perform(intent::SendText(std::string(text.question))).state, IntentState::done);
  ASSERT_TRUE(run_until([this] { return !now().pieces.running && !now().any_axis_moving(); }, seconds(60)));
  EXPECT_EQ(axis().commanded(), Steps(300));
  EXPECT_TRUE(now().pieces.ended_because.view().empty());
}

TEST_P(BacklashContract, ATextThatDoesSomethingEndsItAndThatIsReported) {
  const WireTexts& text = wire_texts(GetParam()->model);
  lowest_on_the_way(to(800), 800);
  EXPECT_EQ(perform(to(300)).state, IntentState::done);
  const bool refused = session->catalog().can.one_axis_at_a_time;  // during a move
  EXPECT_EQ(perform(intent::SendText(std::string(text.setting))).state,
            refused ? IntentState::refused : IntentState::done);
  ASSERT_TRUE(run_until([this] { return !now().pieces.running && !now().any_axis_moving(); }, seconds(60)));
  EXPECT_EQ(axis().commanded(), refused ? Steps(300) : Steps(240)) << "what was refused changed nothing";
  if (!refused) {
    EXPECT_THAT(std::string(now().pieces.ended_because.view()), testing::StartsWith("Repeat the move"));
  }
}

TEST_P(BacklashContract, NothingElseMovesInBetween) {
  lowest_on_the_way(to(800), 800);
  EXPECT_EQ(perform(to(300)).state, IntentState::done);
  const IntentOutcome jog = perform(intent::JogStart(AxisId{0}, Sign::plus, Pps(400)));
  EXPECT_EQ(jog.state, IntentState::refused) << "its stop would leave the way back to come";
  EXPECT_EQ(perform(to(900)).state, IntentState::refused);
  ASSERT_TRUE(run_until([this] { return !now().pieces.running && !now().any_axis_moving(); }, seconds(60)));
  EXPECT_EQ(axis().commanded(), Steps(300));
}

TEST_P(BacklashContract, ItsTurnLiesWithinTheLimitsToo) {
  lowest_on_the_way(to(800), 800);
  Travel travel;
  travel.has_minus = true, travel.minus = Steps(280), travel.in_counts = axis().in_counts;
  ASSERT_EQ(perform(intent::SetTravel(AxisId{0}, travel)).state, IntentState::done);
  const IntentOutcome refused = perform(to(300));
  EXPECT_EQ(refused.state, IntentState::refused);
  EXPECT_THAT(std::string(refused.sentence.view()), testing::HasSubstr("backlash"));
  EXPECT_EQ(axis().commanded(), Steps(800));
  EXPECT_EQ(perform(to(340)).state, IntentState::done);
}

TEST_P(BacklashContract, ANegativeOneIsRefused) {
  EXPECT_EQ(perform(intent::SetBacklash(AxisId{0}, {Steps(-1), Sign::plus})).state, IntentState::refused);
  EXPECT_EQ(now().axes[0].backlash.by, Steps(60));
}

}  // namespace
}  // namespace hw
