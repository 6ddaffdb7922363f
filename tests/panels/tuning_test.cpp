// A step is made, recorded, measured and compared; Repeat ends by itself.
#include "panels/tuning/tuning.h"

#include <cmath>

#include "gui/model/step_recorder.h"
#include "tests/panels/panel_stage.h"
#include "tests/panels/window_catalog.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct TuningTest : ::testing::Test {
  explicit TuningTest(int width = 864, int height = 620)
      : s{panel, width, height, 1, gui::Tier::wide, true, test::window_catalog()} {
    s.now.axis_count = 3;
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.stage.frames(2);
  }
  /// As a driver would: 250 samples, the command jumps after 10 ms, the encoder swings in.
  void samples(double damping, int axis = 0, int step = 400) {
    at += std::chrono::seconds(1);
    for (int i = 0; i < (breaks_off ? 60 : 250); ++i) {
      if (i > 30 && i < 30 + missing) continue;
      const double t = (i - 10) / 1000.0, w = 60;
      const double wd = w * std::sqrt(1 - damping * damping);
      const double swing = std::exp(-damping * w * t) *
                           (std::cos(wd * t) + damping / std::sqrt(1 - damping * damping) * std::sin(wd * t));
      AxisSample one;
      one.at = at + Millis(i);
      one.axis = static_cast<std::uint8_t>(axis);
      one.command = Steps(1000 + (i >= 10 ? step : 0));
      one.encoder = Steps(1000 + (i >= 10 ? std::lround(step * (1 - swing)) : 0));
      one.output_known = output_known;
      one.output_percent = static_cast<float>(i >= 10 ? step * swing / 8 : 0);
      s.tab.desk().step_recorder->take(one);
      if (i == 0) s.stage.frames(2);
    }
    s.stage.frames(3);
  }
  /// As many samples are missing from 20 ms behind the step on, or from the 60th on for good.
  int missing = 0;
  bool breaks_off = false;
  /// Three times to and fro, with these dampings on the way there. They are runs 1 to 6.
  void learn_scatter(std::initializer_list<double> dampings) {
    s.click("tuning/scatter");
    for (const double damping : dampings) {
      samples(damping);
      s.stage.frames(30);
      samples(damping, 0, -400);
      s.stage.frames(30);
    }
  }
  void sends_nothing_more() {
    const std::size_t sent = s.sent.size();
    s.stage.frames(60);
    EXPECT_EQ(s.sent.size(), sent);
  }
  /// With two runs drawn and compared: plots at least so high, no number out of sight.
  void expect_readable(float plot, float small_plot, int height) {
    output_known = true;
    for (const double damping : {0.3, 0.7}) {
      s.click("tuning/record");
      samples(damping);
    }
    const auto height_of = [this](const char* id) {
      const gui::Widget* found = s.stage.find(id);
      EXPECT_TRUE(found) << id;
      return found ? found->rect.height() : 0;
    };
    EXPECT_GE(height_of("tuning/plot"), plot);
    EXPECT_GE(height_of("tuning/error"), small_plot);
    EXPECT_GE(height_of("tuning/output"), small_plot);
    for (const char* id : {"overshoot", "rise", "settling", "steady", "crossings", "largest"})
      for (const char* which : {"", "/before", "/change"}) {
        const gui::Widget* number = s.stage.find(fmt::format("tuning/measure/{}{}", id, which));
        ASSERT_TRUE(number) << id << which;
        EXPECT_LE(number->rect.max.y, static_cast<float>(height)) << id << which;
      }
  }
  void end_well() { s.settle(IntentState::done); }

  Tuning panel;
  test::PanelStage s;
  Instant at{};
  bool output_known = false;
};

TEST_F(TuningTest, AStepIsRecordedBeforeItIsMade) {
  s.click("tuning/record");
  const auto* recording = s.last<intent::Sample>();
  ASSERT_TRUE(recording) << "the recording goes first";
  EXPECT_EQ(recording->axis, AxisId{0});
  EXPECT_GE(recording->length, Millis(230));
  AxisSample first;
  s.tab.desk().step_recorder->take(first);
  s.stage.frames(2);
  ASSERT_TRUE(s.last<intent::MoveBy>());
  EXPECT_EQ(s.last<intent::MoveBy>()->distances[0].value, Steps(400));
  EXPECT_THAT(s.reason("tuning/record"), HasSubstr("being recorded"));
}

TEST_F(TuningTest, ItIsMeasured) {
  s.click("tuning/record");
  samples(0.5);
  EXPECT_EQ(s.value("tuning/measure/overshoot"), "16.2 %") << "exp(-pi d / sqrt(1 - d²))";
  EXPECT_THAT(s.value("tuning/measure/settling"), HasSubstr(" ms"));
  EXPECT_THAT(s.value("tuning/measure/rise"), HasSubstr("27."));
  EXPECT_THAT(s.value("tuning/measure/steady"), HasSubstr(" counts"));
  EXPECT_EQ(s.value("tuning/plot"), "250 samples, command 400, encoder 400");
  EXPECT_EQ(s.reason("tuning/record"), "");
}

TEST_F(TuningTest, TheOutputIsShownAsWorkedOutAndOnlyWhereItIsKnown) {
  s.click("tuning/record");
  samples(0.5);
  EXPECT_FALSE(s.stage.find("tuning/output")) << "a gain is not known";
  output_known = true;
  for (const int step : {400, -400}) {
    s.click("tuning/record");
    samples(0.5, 0, step);
    EXPECT_EQ(s.value("tuning/output"), "calculated, not read: at most 50 %");
  }
  s.click("tuning/record");
  EXPECT_TRUE(s.stage.find("tuning/output")) << "nothing jumps while the next one begins";
}

TEST_F(TuningTest, AMeasureAcrossAGapIsReportedAsUnsure) {
  s.click("tuning/record");
  samples(0.5);
  missing = 40;
  s.click("tuning/record");
  samples(0.5);
  EXPECT_THAT(s.value("tuning/measure/overshoot"), HasSubstr(" % or more"));
  EXPECT_THAT(s.value("tuning/measure/rise"), HasSubstr(" to "));
  EXPECT_EQ(s.value("tuning/measure/overshoot/change"), "not sure: a gap");
}

TEST_F(TuningTest, ARecordingThatBreaksOffIsNotMeasuredAsIfItWereWhole) {
  breaks_off = true;
  s.click("tuning/record");
  samples(0.5);
  s.stage.frames(60 * 3);
  EXPECT_THAT(s.value("tuning/measure/overshoot"), HasSubstr(" % or more"));
  EXPECT_EQ(s.value("tuning/measure/settling"), "gap in it");
  EXPECT_EQ(s.value("tuning/measure/steady"), "gap in it");
}

TEST_F(TuningTest, SameIsReportedOnlyOfAScatterThatIsKnown) {
  for (int i = 0; i < 2; ++i) {
    s.click("tuning/record");
    samples(0.5);
  }
  EXPECT_EQ(s.value("tuning/measure/overshoot/change"), "0.0 %");
  learn_scatter({0.5, 0.5, 0.5});
  s.click("tuning/record");
  samples(0.5);
  EXPECT_EQ(s.value("tuning/measure/overshoot/change"), "same");
}

// The room in the centre of a window of 1024 x 700; of 1440 x 900, where the terminal gives way.
struct TuningInASmallWindow : TuningTest {
  TuningInASmallWindow() : TuningTest(704, 452) {}
};
TEST_F(TuningInASmallWindow, PlotsCanBeReadAndAllNumbersAreInSight) { expect_readable(160, 84, 452); }
struct TuningInAUsualWindow : TuningTest {
  TuningInAUsualWindow() : TuningTest(864, 616) {}
};
TEST_F(TuningInAUsualWindow, PlotsCanBeReadAndAllNumbersAreInSight) { expect_readable(248, 88, 616); }

TEST_F(TuningTest, TheNextRunIsComparedWithTheOneBefore) {
  s.click("tuning/record");
  samples(0.3);
  EXPECT_FALSE(s.stage.find("tuning/measure/overshoot/before"));
  s.click("tuning/record");
  samples(0.7);
  EXPECT_EQ(s.value("tuning/measure/overshoot/before"), "37.2 %");
  EXPECT_EQ(s.value("tuning/measure/overshoot/change"), "-32.8 %") << "no verdict: the scatter is not known";
}

TEST_F(TuningTest, BetterAndWorseAreReportedWhenTheScatterIsKnown) {
  learn_scatter({0.5, 0.5, 0.5});
  sends_nothing_more();
  s.click("tuning/record");
  samples(0.3);
  s.click("tuning/record");
  samples(0.7);
  EXPECT_EQ(s.value("tuning/measure/overshoot/before"), "37.2 %");
  EXPECT_THAT(s.value("tuning/measure/overshoot/change"), HasSubstr("better"));
  s.click("tuning/record");
  samples(0.5);
  EXPECT_THAT(s.value("tuning/measure/overshoot/change"), HasSubstr("worse"));
  s.click("tuning/compare");
  s.click("tuning/compare/run 7");
  EXPECT_EQ(s.value("tuning/measure/overshoot/before"), "37.2 %");
  EXPECT_THAT(s.value("tuning/measure/overshoot/change"), HasSubstr("better"));
}

TEST_F(TuningTest, ADifferenceWithinTheScatterCountsAsTheSame) {
  learn_scatter({0.45, 0.5, 0.55});
  s.click("tuning/record");
  samples(0.5);
  s.click("tuning/record");
  samples(0.53);
  EXPECT_EQ(s.value("tuning/measure/overshoot/change"), "same");
  s.click("tuning/record");
  samples(0.7);
  EXPECT_THAT(s.value("tuning/measure/overshoot/change"), HasSubstr("better"));
}

TEST_F(TuningTest, RepeatGoesToAndFroAndEndsWithTheNextPress) {
  s.click("tuning/repeat");
  samples(0.5);
  s.stage.frames(30);
  samples(0.5, 0, -400);
  ASSERT_TRUE(s.last<intent::MoveBy>());
  EXPECT_EQ(s.last<intent::MoveBy>()->distances[0].value, Steps(-400));
  EXPECT_EQ(s.value("tuning/measure/overshoot"), "16.2 %") << "turned into the direction of its step";
  s.click("tuning/repeat");
  sends_nothing_more();
}

TEST_F(TuningTest, RepeatEndsWhereItBegan) {
  s.click("tuning/repeat");
  samples(0.5);
  s.click("tuning/repeat");
  s.stage.frames(30);
  samples(0.5, 0, -400);
  EXPECT_EQ(s.last<intent::MoveBy>()->distances[0].value, Steps(-400));
  sends_nothing_more();
  EXPECT_EQ(s.reason("tuning/record"), "") << "Repeat is off";
}

TEST_F(TuningTest, AfterAStopItDoesNotGoBack) {
  s.click("tuning/repeat");
  samples(0.5);
  s.click("tuning/repeat");
  s.now.axes[0].ended_by = EndedBy::stop;
  s.stage.frames(2);
  sends_nothing_more();
}

TEST_F(TuningTest, RepeatWaitsForAnAxisThatSettles) {
  s.click("tuning/repeat");
  s.now.axes[0].activity = Activity::moving;
  samples(0.5);
  sends_nothing_more();
  const std::size_t sent = s.sent.size();
  s.now.axes[0].activity = Activity::idle;
  s.now.axes[0].ended_by = EndedBy::not_in_place;
  s.stage.frames(5);
  EXPECT_GT(s.sent.size(), sent) << "a loop that does not come there is what is being tuned";
}

TEST_F(TuningTest, RepeatIsNotCarriedOnAfterAStop) {
  s.click("tuning/repeat");
  s.now.axes[0].ended_by = EndedBy::stop;
  samples(0.5);
  sends_nothing_more();
  EXPECT_THAT(s.toast(), HasSubstr("Repeat is off"));
}

TEST_F(TuningTest, RepeatEndsWhenAnotherCommandWasSent) {
  s.click("tuning/repeat");
  samples(0.5);
  IntentOutcome other;
  other.id = s.sent.size() + 1, other.state = IntentState::done;  // a stop while it stood
  s.now.outcomes[0] = other;
  sends_nothing_more();
}

// Whatever comes while the step is recorded, not only between two.
struct TuningInterrupted : TuningTest {
  void expect_ended(const char* why) {
    samples(0.5);
    const std::size_t sent = s.sent.size();
    s.stage.frames(60);
    EXPECT_EQ(s.sent.size(), sent) << "nothing moves by itself";
    EXPECT_THAT(s.toast(), HasSubstr(why));
    EXPECT_EQ(s.reason("tuning/record"), "") << "Repeat is off";
  }
  void repeat_until_the_step_is_made() {
    s.click("tuning/repeat");
    AxisSample first;
    s.tab.desk().step_recorder->take(first);
    s.stage.frames(2);
    ASSERT_TRUE(s.last<intent::MoveBy>());
  }
};
TEST_F(TuningInterrupted, ByAnotherPanelInFront) {
  repeat_until_the_step_is_made();
  s.stage.now_s += 1.5;  // not so long that the recording has ended for want of samples
  s.stage.frames(1);
  expect_ended("another panel was in front");
}
TEST_F(TuningInterrupted, ByAnotherPanelBeforeTheStep) {
  s.click("tuning/repeat");
  s.stage.now_s += 20;
  s.tab.desk().step_recorder->take(AxisSample());
  s.stage.frames(30);
  EXPECT_FALSE(s.last<intent::MoveBy>());
  EXPECT_THAT(s.toast(), HasSubstr("The step was not made"));
  EXPECT_EQ(s.reason("tuning/record"), "");
}
TEST_F(TuningInterrupted, ByALinkThatIsLate) {
  repeat_until_the_step_is_made();
  s.now.link.state = LinkState::late;
  s.stage.frames(1);
  s.now.link.state = LinkState::good;
  expect_ended("did not answer");
}
TEST_F(TuningInterrupted, ByAReset) {
  repeat_until_the_step_is_made();
  ++s.now.restarts;
  s.stage.frames(1);
  expect_ended("was reset");
}

TEST_F(TuningTest, AStopBeforeTheStepKeepsItFromBeingMade) {
  s.click("tuning/record");
  IntentOutcome stop;
  stop.id = s.sent.size() + 1, stop.state = IntentState::done;
  s.now.outcomes[0] = stop;
  s.stage.frames(2);
  s.tab.desk().step_recorder->take(AxisSample());
  s.stage.frames(2);
  EXPECT_FALSE(s.last<intent::MoveBy>());
  EXPECT_THAT(s.toast(), HasSubstr("was not made"));
}

TEST_F(TuningTest, ARefusedStepIsReportedAndIsNoRun) {
  s.click("tuning/repeat");
  s.tab.desk().step_recorder->take(AxisSample());
  s.stage.frames(2);
  s.settle(IntentState::refused, "X is off. Nothing was sent.");
  EXPECT_EQ(s.toast(), "X is off. Nothing was sent.");
  EXPECT_FALSE(s.stage.find("tuning/measure/overshoot"));
  EXPECT_EQ(s.reason("tuning/record"), "");
}

TEST_F(TuningTest, NothingRecordedIsNoResponse) {
  s.click("tuning/record");
  s.stage.frames(60 * 3);
  EXPECT_THAT(s.toast(), HasSubstr("No sample arrived"));
  EXPECT_FALSE(s.stage.find("tuning/measure/overshoot"));
}

TEST_F(TuningTest, GainsOfTheChosenAxisAreSentOnSend) {
  const std::size_t sent = s.sent.size();
  s.type("tuning/KPX", "12.5\n");
  EXPECT_EQ(s.sent.size(), sent) << "typed, not sent";
  s.click("tuning/send");
  ASSERT_EQ(s.sent.size(), sent + 1);
  ASSERT_TRUE(s.last<intent::SetParam>());
  EXPECT_EQ(s.last<intent::SetParam>()->mnemonic, "KPX");
  EXPECT_EQ(s.last<intent::SetParam>()->value, 1250);
  s.now.params[0].value = 1250;
  s.stage.frames(2);
  EXPECT_EQ(s.reason("tuning/send"), "No gain has been changed.");
  EXPECT_FALSE(s.stage.find("tuning/KPY"));
  s.click("tuning/axis");
  s.click("tuning/axis/Y");
  EXPECT_TRUE(s.stage.find("tuning/KPY"));
  EXPECT_FALSE(s.stage.find("tuning/KPX"));
  EXPECT_FALSE(s.stage.find("tuning/axis/Z")) << "it has no gains";
}

TEST_F(TuningTest, WithoutALinkNothingMoves) {
  s.now.link.state = LinkState::lost;
  s.stage.frames(2);
  EXPECT_EQ(s.reason("tuning/record"), "There is no link.");
  EXPECT_EQ(s.reason("tuning/repeat"), "There is no link.");
}

}  // namespace
}  // namespace hw::panels
