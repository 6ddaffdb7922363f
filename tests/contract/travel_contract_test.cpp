// The user's own limits on every controller: what would go past one is refused, and a jog ends there by the
// controller itself.
#include "core/device/travel_check.h"
#include "tests/contract/rig.h"

namespace hw {
namespace {

using std::chrono::seconds;
using testing::AllOf;
using testing::HasSubstr;

class TravelContract : public ContractTest {
 protected:
  static constexpr Steps minus{-300}, plus{800};

  void begin() {
    if (session->catalog().axes[0].switchable) perform(intent::SetPower(0, true));
    run(seconds(1));
    ASSERT_EQ(perform(intent::SetTravel(AxisId{0}, travel())).state, IntentState::done);
  }
  Travel travel() const {
    Travel t;
    t.has_minus = t.has_plus = true;
    t.minus = minus, t.plus = plus;
    t.in_counts = now().axes[0].in_counts;
    return t;
  }
  IntentOutcome go_to(std::int64_t place) { return done(intent::MoveTo({{AxisId{0}, Steps(place)}})); }
  IntentOutcome go_by(std::int64_t by) { return done(intent::MoveBy({{AxisId{0}, Steps(by)}})); }
  IntentOutcome done(IntentBody body) {
    const IntentOutcome outcome = perform(std::move(body));
    EXPECT_TRUE(becomes_idle(seconds(60)));
    return outcome;
  }
  Steps stands() { return now().axes[0].commanded(); }
};

INSTANTIATE_TEST_SUITE_P(Every, TravelContract, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(TravelContract, AMovePastTheLimitIsNotSent) {
  ASSERT_NO_FATAL_FAILURE(begin());
  const IntentOutcome refused = go_to(1000);
  EXPECT_EQ(refused.state, IntentState::refused);
  EXPECT_THAT(std::string(refused.sentence.view()),
              AllOf(HasSubstr("1000 "), HasSubstr(" lies 200 "), HasSubstr(" past the + limit of "),
                    HasSubstr("Nothing was sent.")));
  ASSERT_TRUE(refused.past);
  EXPECT_EQ(refused.past->nearest, plus);
  EXPECT_EQ(stands(), Steps(0));
  EXPECT_EQ(go_to(800).state, IntentState::done) << "the limit itself is inside";
  EXPECT_EQ(stands(), plus);
  EXPECT_EQ(go_by(1).state, IntentState::refused);
  EXPECT_EQ(go_by(-100).state, IntentState::done);
  EXPECT_EQ(go_by(-1001).state, IntentState::refused) << "700 - 1001 lies past the other one";
  EXPECT_EQ(stands(), Steps(700));
}

TEST_P(TravelContract, AJogEndsAtTheLimitWithoutTheConsole) {
  ASSERT_NO_FATAL_FAILURE(begin());
  for (const Sign sign : {Sign::plus, Sign::minus, Sign::plus}) {
    const Steps end = sign == Sign::plus ? plus : minus;
    EXPECT_EQ(perform(intent::JogStart(AxisId{0}, sign, Pps(400), false)).state, IntentState::done);
    run(Millis(400));
    EXPECT_EQ(axis().activity, Activity::jogging);
    ASSERT_TRUE(becomes_idle(seconds(60)));
    EXPECT_EQ(stands(), end);
    EXPECT_EQ(axis().ended_by, EndedBy::target);
    EXPECT_EQ(perform(intent::JogStart(AxisId{0}, sign, Pps(400), false)).state, IntentState::refused);
  }
}

TEST_P(TravelContract, AHandLetsGoOfAJogUnderLimitsAsOfAnyOther) {
  ASSERT_NO_FATAL_FAILURE(begin());
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps(400))).state, IntentState::done);
  for (int i = 0; i < 5; ++i) {
    run(Millis(100));
    session->send(intent::JogKeepAlive());
  }
  perform(intent::JogStop());
  ASSERT_TRUE(becomes_idle(seconds(10)));
  EXPECT_GT(stands(), Steps(50));
  EXPECT_LT(stands(), Steps(700));
  EXPECT_EQ(axis().ended_by, EndedBy::stop);
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps(400))).state, IntentState::done);
  run(seconds(1));  // nobody keeps it alive
  ASSERT_TRUE(becomes_idle(seconds(10)));
  EXPECT_LT(stands(), plus) << "the dead man's hand";
}

TEST_P(TravelContract, FromOutsideTheWayBackIsFree) {
  ASSERT_NO_FATAL_FAILURE(begin());
  perform(intent::SetTravel(AxisId{0}, Travel()));
  EXPECT_EQ(go_to(1500).state, IntentState::done);
  perform(intent::SetTravel(AxisId{0}, travel()));
  EXPECT_EQ(go_by(10).state, IntentState::refused);
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps(400), false)).state, IntentState::refused);
  EXPECT_EQ(go_to(1200).state, IntentState::done) << "still outside, and nearer";
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::minus, Pps(400), false)).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(seconds(60)));
  EXPECT_EQ(stands(), minus);
}

TEST_P(TravelContract, LimitsByADoubtfulCountHoldNothing) {
  ASSERT_NO_FATAL_FAILURE(begin());
  operate(bench::PowerCycle());
  ASSERT_TRUE(
      run_until([this] { return now().link.state == LinkState::good && now().restarts == 1; }, seconds(60)));
  run(seconds(2));
  if (session->catalog().axes[0].switchable) perform(intent::SetPower(0, true));
  run(seconds(1));
  ASSERT_TRUE(axis().trust.doubtful());
  EXPECT_FALSE(axis().travel_holds());
  EXPECT_EQ(go_by(900).state, IntentState::done) << "a way out must be left";
  EXPECT_EQ(axis().travel, travel()) << "they are kept, and hold again when it is told where it stands";
}

TEST_P(TravelContract, BacklashIsNotTakenUpFromBeyondALimit) {
  ASSERT_NO_FATAL_FAILURE(begin());
  perform(intent::SetBacklash(AxisId{0}, Backlash{Steps(50), Sign::minus}));
  const IntentOutcome refused = go_to(780);
  EXPECT_EQ(refused.state, IntentState::refused);
  ASSERT_TRUE(refused.past);
  EXPECT_EQ(nearest_allowed(now(), *refused.past), Steps(750));
  EXPECT_EQ(stands(), Steps(0));
  EXPECT_EQ(go_to(750).state, IntentState::done);
  EXPECT_EQ(stands(), Steps(750));
}

TEST_P(TravelContract, EndsThatCrossAreRefused) {
  Travel crossed = travel();
  std::swap(crossed.minus, crossed.plus);
  const IntentOutcome refused = perform(intent::SetTravel(AxisId{0}, crossed));
  EXPECT_EQ(refused.state, IntentState::refused);
  EXPECT_FALSE(axis().travel.any());
}

}  // namespace
}  // namespace hw
