// Steps are recorded whichever panel is in front; nothing moves by itself while nobody looks.
#include "gui/model/step_recorder.h"

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
  /// The command jumps after 10 ms; the encoder follows at once.
  void samples(int from, int to) {
    for (int i = from; i < to; ++i) {
      AxisSample one;
      one.at = Instant(Millis(i));
      one.command = one.encoder = Steps(i >= 10 ? 400 : 0);
      recorder.take(one);
    }
  }
  void begin_and_step() {
    frames(1, true);
    samples(0, 1);
    frames(1, true);
    ASSERT_TRUE(std::holds_alternative<intent::MoveBy>(sent.back()));
  }
  std::string told() {
    std::string all;
    for (const Told& one : recorder.take_told()) all += one.sentence;
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
  EXPECT_EQ(told(), "");
}

TEST_F(StepRecorderTest, ASeriesEndsWhenItsPanelLeavesTheFront) {
  recorder.repeat(plan, view());
  begin_and_step();
  frames(2, false);
  EXPECT_THAT(told(), HasSubstr("Repeat is off: another panel was in front"));
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
  EXPECT_EQ(told(), "Stopped: Repeat is off.");
}

TEST_F(StepRecorderTest, AStopEndsTheSeriesBeforeItsNextStep) {
  recorder.repeat(plan, view());
  begin_and_step();
  samples(1, 250);
  frames(1, true);
  recorder.stopped();
  frames(60, true);
  EXPECT_EQ(sent.size(), 2u);
  EXPECT_EQ(told(), "Stopped: Repeat is off.");
}

TEST_F(StepRecorderTest, AStopWhileNothingIsDoneForbidsNoLaterStep) {
  recorder.stopped();
  recorder.record(plan, view());
  begin_and_step();
  EXPECT_EQ(told(), "");
}

}  // namespace
}  // namespace hw::gui
