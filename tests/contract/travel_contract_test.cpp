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

/// Texts by model; {} is a distance or a place, which is the same from 0.
struct MovingText {
  std::string_view model, moves, jogs;
  std::string_view filler;  ///< commands that change nothing, for one long text; empty: one command a text
};
constexpr MovingText moving_texts[] = {
    {"vxm", "I1M900,R", "I1M100,L0,R", "P1,"},
    {"pmx-4ex-sa", "X900", "JX+", ""},
    {"dmx-k-sa", "X900", "J+", ""},
    {"vme58", "AX MR900 GO", "AX JG500", "WT1 "},
};

class TextTravelContract : public TravelContract {
 protected:
  void SetUp() override {
    const auto text = std::find_if(std::begin(moving_texts), std::end(moving_texts),
                                   [](const MovingText& t) { return t.model == GetParam()->model; });
    if (text == std::end(moving_texts)) GTEST_SKIP() << "its texts are not known here";
    text_ = *text;
    TravelContract::SetUp();
    if (GetParam()->model == "vxm") perform(intent::SetParam("M1M", 4, true));
    ASSERT_NO_FATAL_FAILURE(begin());
  }
  std::string warning() {
    std::string all;
    session->notices().drain([&](const Notice& notice) {
      if (notice.past && notice.past->of == PastTravel::Of::text) all += notice.text;
    });
    return all;
  }
  MovingText text_;
};

INSTANTIATE_TEST_SUITE_P(Every, TextTravelContract, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(TextTravelContract, ATypedTextThatLeadsPastALimitIsSentAndWarnedOf) {
  EXPECT_EQ(perform(intent::SendText(std::string(text_.moves))).state, IntentState::done);
  EXPECT_THAT(warning(), AllOf(HasSubstr("This text moves past a limit: 900 "), HasSubstr(" lies 100 "),
                               HasSubstr(" past the + limit of "), HasSubstr("It was sent as it is.")));
  EXPECT_LT(stands(), plus) << "before it goes there";
  ASSERT_TRUE(run_until([this] { return stands() == Steps(900); }, seconds(60))) << "it goes anyway";
}

TEST_P(TextTravelContract, SoIsTheTextOfAScript) {
  bool asked = false;
  asio::co_spawn(
      time.executor(),
      [](Session& of, std::string text, bool& done) -> Task<> {
        (void)co_await of.pump().query(std::move(text), Millis(200));
        done = true;
      }(*session, std::string(text_.moves), asked),
      asio::detached);
  ASSERT_TRUE(run_until([&] { return asked; }, seconds(10)));
  EXPECT_THAT(warning(), HasSubstr("This text moves past a limit: 900 "));
}

TEST_P(TextTravelContract, AMovePreparedByOneTextAndStartedByAnotherIsWarnedOf) {
  const std::size_t start = text_.moves.rfind(GetParam()->model == "vme58" ? 'G' : 'R');
  if (text_.filler.empty() || start == std::string_view::npos) GTEST_SKIP() << "a text of it is one command";
  perform(intent::SendText(std::string(text_.moves.substr(0, start))));
  EXPECT_EQ(warning(), "");
  run(seconds(2));
  perform(intent::SendText(std::string(text_.moves.substr(start))));
  EXPECT_THAT(warning(), HasSubstr("This text moves past a limit: 900 "));
  perform(intent::Stop());
  EXPECT_TRUE(becomes_idle(seconds(60)));
}

TEST_P(TextTravelContract, OneThatStaysInsideOrLeadsBackIsNot) {
  perform(intent::SetTravel(AxisId{0}, Travel()));
  EXPECT_EQ(perform(intent::SendText(std::string(text_.moves))).state, IntentState::done);
  ASSERT_TRUE(run_until([this] { return stands() == Steps(900); }, seconds(60)));
  EXPECT_EQ(warning(), "") << "there is no limit";
}

TEST_P(TextTravelContract, AJogThatNothingEndsIsWarnedOf) {
  EXPECT_EQ(perform(intent::SendText(std::string(text_.jogs))).state, IntentState::done);
  EXPECT_THAT(warning(), HasSubstr("This text moves past a limit: "));
  perform(intent::Stop());
  EXPECT_TRUE(becomes_idle(seconds(60)));
}

TEST_P(TextTravelContract, HoweverLongItIs) {
  if (text_.filler.empty()) GTEST_SKIP() << "a text of it is one command";
  std::string text;
  while (text.size() < 600) text += text_.filler;
  if (GetParam()->model == "vxm") text = "I1M1,I1M-1,I1M1,I1M-1," + std::string(600, ' ');
  perform(intent::SendText((GetParam()->model == "vme58" ? "AX " : "") + text + std::string(text_.moves)));
  EXPECT_THAT(warning(), HasSubstr("This text moves past a limit: 900 "));
  perform(intent::Stop());
  EXPECT_TRUE(becomes_idle(seconds(60)));
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
