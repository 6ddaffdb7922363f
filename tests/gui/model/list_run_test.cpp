// A list is loaded and started by its job, unless a stop or another panel comes between.
#include "gui/model/list_run.h"

#include <gmock/gmock.h>

namespace hw::gui {
namespace {

using ::testing::HasSubstr;

struct ListRunTest : ::testing::Test {
  void begin() { run.begin("line 1 0\n", {AxisTarget{AxisId{0}, Steps(1)}}, send); }
  void frame(bool looked_at = true) {
    run.follow(now, send, words);
    if (looked_at) run.looked_at();
  }
  void settle(IntentState state, const char* sentence = "") {
    now.outcomes[0].id = sent.size();
    now.outcomes[0].state = state;
    now.outcomes[0].sentence = sentence;
  }
  [[nodiscard]] bool started() const { return std::holds_alternative<intent::RunProgram>(sent.back()); }

  ListRun run;
  ListRun::Words words = [](const IntentOutcome& ended) {
    return "In its unit: " + std::string(ended.sentence.view());
  };
  Snapshot now;
  std::vector<IntentBody> sent;
  ListRun::Send send = [this](IntentBody body) {
    sent.push_back(std::move(body));
    return static_cast<IntentId>(sent.size());
  };
};

TEST_F(ListRunTest, ItIsStartedWithItsPlacesWhenItIsLoaded) {
  begin();
  frame();
  EXPECT_FALSE(started());
  settle(IntentState::done);
  frame();
  ASSERT_TRUE(started());
  EXPECT_EQ(std::get<intent::RunProgram>(sent.back()).places.size(), 1u);
  settle(IntentState::done);
  frame();
  EXPECT_FALSE(run.busy());
}

TEST_F(ListRunTest, ItIsNotStartedAfterAStop) {
  begin();
  frame();
  run.stopped();
  settle(IntentState::done);
  frame();
  EXPECT_FALSE(started());
}

TEST_F(ListRunTest, ItIsNotStartedOnceAnotherPanelIsInFrontAndReportsIt) {
  begin();
  frame();
  frame(false);
  frame(false);
  settle(IntentState::done);
  frame(false);
  EXPECT_FALSE(started());
  const auto reported = run.take_report();
  ASSERT_EQ(reported.size(), 1u);
  EXPECT_THAT(reported[0].sentence, HasSubstr("came to the front before it began"));
}

TEST_F(ListRunTest, ItIsBusyUntilItIsLoadedAndAFailureIsReportedWhateverPanelIsInFront) {
  begin();
  frame();
  frame(false);
  frame(false);
  EXPECT_TRUE(run.busy());
  EXPECT_TRUE(run.take_report().empty()) << "it is under way still";
  settle(IntentState::failed, "The link was lost.");
  frame();
  EXPECT_FALSE(run.busy());
  const auto reported = run.take_report();
  ASSERT_EQ(reported.size(), 1u);
  EXPECT_EQ(reported[0].sentence, "In its unit: The link was lost.");
}

TEST_F(ListRunTest, ARefusedStartIsReportedEvenIfNoPanelTakesIt) {
  begin();
  frame();
  settle(IntentState::done);
  frame();
  ASSERT_TRUE(started());
  frame(false);
  settle(IntentState::refused, "X is off.");
  frame(false);
  EXPECT_FALSE(run.take_refusal());
  const auto reported = run.take_report();
  ASSERT_EQ(reported.size(), 1u);
  EXPECT_EQ(reported[0].sentence, "In its unit: X is off.");
}

}  // namespace
}  // namespace hw::gui
