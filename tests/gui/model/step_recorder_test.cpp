// Steps are recorded whichever panel is in front; nothing moves by itself while nobody looks.
#include "gui/model/step_recorder.h"

#include <algorithm>

#include <gmock/gmock.h>

namespace hw::gui {
namespace {

using ::testing::HasSubstr;

struct StepRecorderTest : ::testing::Test {
  StepRecorderTest() {
    now.link.state = LinkState::good;
    now.axes[0].activity = Activity::idle;
  }
  StepRecorder::View view() {
    return {now, clock, [](AxisId) { return std::string_view(); },
            [this](IntentBody body) {
              sent.push_back(std::move(body));
              return static_cast<IntentId>(sent.size());
            }};
  }
  void frames(int n, bool looked_at) {
    for (int i = 0; i < n; ++i) {
      clock += Millis(20);
      recorder.follow(view());
      if (looked_at) recorder.looked_at();
    }
  }
  /// The command jumps after 10 ms; the encoder follows within 5 ms.
  void samples(int from, int to, int step = 400) {
    for (int i = from; i < to; ++i) {
      AxisSample one;
      one.at = Instant(Millis(i));
      one.command = Steps(i >= 10 ? step : 0);
      one.encoder = Steps(step * std::clamp(i - 9, 0, 5) / 5);
      recorder.take(one);
    }
  }
  void one_step(int step, int missing_from = 250) {
    begin_and_step(step);
    samples(1, missing_from, step);
    samples(missing_from + 20, 250, step);
    frames(40, true);  // measures, and pauses
  }
  void begin_and_step(int step = 400) {
    frames(1, true);
    samples(0, 1, step);
    frames(1, true);
    ASSERT_TRUE(std::holds_alternative<intent::MoveBy>(sent.back()));
  }
  std::string reported() {
    std::string all;
    for (const Report& one : recorder.take_report()) all += one.sentence;
    return all;
  }

  const StepRecorder::Plan plan{AxisId{0}, Steps(400), 230};
  StepRecorder recorder;
  Snapshot now;
  Instant clock{};
  std::vector<IntentBody> sent;
};

TEST_F(StepRecorderTest, ARecordingIsMeasuredWhileAnotherPanelIsInFront) {
  recorder.record(plan, view());
  begin_and_step();
  samples(1, 250);
  frames(3, false);
  EXPECT_EQ(recorder.measured_number(), 1);
  EXPECT_TRUE(recorder.measured().rose);
  EXPECT_FALSE(recorder.busy());
  EXPECT_EQ(reported(), "");
}

TEST_F(StepRecorderTest, ASeriesEndsWhenItsPanelLeavesTheFront) {
  recorder.repeat(plan, view());
  begin_and_step();
  frames(2, false);
  EXPECT_THAT(reported(), HasSubstr("Repeat is off: another panel was in front"));
  samples(1, 250);
  frames(60, true);
  EXPECT_EQ(sent.size(), 2u) << "one recording and one step";
  EXPECT_EQ(recorder.measured_number(), 1);
}

TEST_F(StepRecorderTest, AMeasuredRunStaysWhenTheSeriesEndsBetweenTwoSteps) {
  recorder.repeat(plan, view());
  begin_and_step();
  samples(1, 250);
  frames(1, true);
  ASSERT_EQ(recorder.measured_number(), 1);
  now.outcomes[0].id = sent.size();
  now.outcomes[0].state = IntentState::failed;
  recorder.stopped();
  frames(1, true);
  EXPECT_EQ(recorder.runs().size(), 1u);
  EXPECT_EQ(reported(), "Stopped: Repeat is off.");
}

TEST_F(StepRecorderTest, AStopEndsTheSeriesBeforeItsNextStep) {
  recorder.repeat(plan, view());
  begin_and_step();
  samples(1, 250);
  frames(1, true);
  recorder.stopped();
  frames(60, true);
  EXPECT_EQ(sent.size(), 2u);
  EXPECT_EQ(reported(), "Stopped: Repeat is off.");
}

TEST_F(StepRecorderTest, ARepetitionWithAGapIsMadeAgain) {
  recorder.learn_scatter(plan, view());
  for (const int missing_from : {250, 50, 250}) one_step(400, missing_from), one_step(-400);
  EXPECT_FALSE(recorder.scatter().known()) << "two only were seen whole";
  one_step(400), one_step(-400);
  EXPECT_TRUE(recorder.scatter().known());
  EXPECT_FALSE(recorder.busy());
  EXPECT_THAT(reported(), HasSubstr("Three repetitions are measured"));
}

TEST_F(StepRecorderTest, WhereEachRepetitionHasAGapTheScatterStaysUnknownAndThatIsReported) {
  recorder.learn_scatter(plan, view());
  for (int i = 0; i < 6; ++i) one_step(400, 50), one_step(-400);
  EXPECT_FALSE(recorder.scatter().known());
  EXPECT_FALSE(recorder.busy()) << "it gives up, where it began";
  EXPECT_THAT(reported(), HasSubstr("gaps"));
}

TEST_F(StepRecorderTest, RepetitionsThatTheUserEndedCountForNoScatterAndBlameNothing) {
  recorder.learn_scatter(plan, view());
  one_step(400), one_step(-400);
  begin_and_step();
  recorder.end_where_it_began();
  samples(1, 50);
  samples(70, 250);
  frames(40, true);
  one_step(-400);
  EXPECT_FALSE(recorder.busy()) << "it is back where it began";
  EXPECT_FALSE(recorder.scatter().known());
  EXPECT_EQ(reported(), "");
}

TEST_F(StepRecorderTest, AStopWhileNothingIsDoneForbidsNoLaterStep) {
  recorder.stopped();
  recorder.record(plan, view());
  begin_and_step();
  EXPECT_EQ(reported(), "");
}

}  // namespace
}  // namespace hw::gui
