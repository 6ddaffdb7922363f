// A step is made, recorded, measured and compared; Repeat ends by itself.
#include "panels/tuning.h"

#include <cmath>

#include "tests/panels/panel_stage.h"
#include "tests/panels/window_catalog.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct TuningTest : ::testing::Test {
  TuningTest() {
    s.now.axis_count = 3;
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.stage.frames(2);
  }
  /// As a driver would: 250 samples, the command jumps after 10 ms, the encoder swings in.
  void samples(double damping, int axis = 0, int step = 400) {
    at += std::chrono::seconds(1);
    for (int i = 0; i < 250; ++i) {
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
      panel.take(one);
      if (i == 0) s.stage.frames(2);
    }
    s.stage.frames(3);
  }
  void end_well() { s.settle(Fate::done); }

  Tuning panel;
  test::PanelStage s{panel, 864, 620, 1, gui::Tier::wide, true, test::window_catalog()};
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
  panel.take(first);
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
    EXPECT_EQ(s.value("tuning/output"), "worked out, not read: at most 50 %");
  }
  s.click("tuning/record");
  EXPECT_TRUE(s.stage.find("tuning/output")) << "nothing jumps while the next one begins";
}

TEST_F(TuningTest, TheNextRunIsComparedWithTheOneBefore) {
  s.click("tuning/record");
  samples(0.3);
  EXPECT_FALSE(s.stage.find("tuning/measure/overshoot/before"));
  s.click("tuning/record");
  samples(0.7);
  EXPECT_EQ(s.value("tuning/measure/overshoot/before"), "37.2 %");
  EXPECT_THAT(s.value("tuning/measure/overshoot/change"), HasSubstr("better"));
  s.click("tuning/record");
  samples(0.5);
  EXPECT_THAT(s.value("tuning/measure/overshoot/change"), HasSubstr("worse"));
  s.click("tuning/compare");
  s.click("tuning/compare/run 1");
  EXPECT_EQ(s.value("tuning/measure/overshoot/before"), "37.2 %");
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
  const std::size_t sent = s.sent.size();
  s.stage.frames(60);
  EXPECT_EQ(s.sent.size(), sent);
}

TEST_F(TuningTest, RepeatIsNotCarriedOnAfterAStop) {
  s.click("tuning/repeat");
  s.now.axes[0].ended_by = EndedBy::stop;
  samples(0.5);
  const std::size_t sent = s.sent.size();
  s.stage.frames(60);
  EXPECT_EQ(s.sent.size(), sent);
  EXPECT_THAT(s.toast(), HasSubstr("Repeat is off"));
}

TEST_F(TuningTest, RepeatIsNotCarriedOnAfterAnybodyElseHasSentSomething) {
  s.click("tuning/repeat");
  samples(0.5);
  IntentFate other;
  other.id = s.sent.size() + 1, other.fate = Fate::done;  // a stop while it stood
  s.now.fates[0] = other;
  const std::size_t sent = s.sent.size();
  s.stage.frames(60);
  EXPECT_EQ(s.sent.size(), sent);
}

TEST_F(TuningTest, AStopBeforeTheStepKeepsItFromBeingMade) {
  s.click("tuning/record");
  IntentFate stop;
  stop.id = s.sent.size() + 1, stop.fate = Fate::done;
  s.now.fates[0] = stop;
  s.stage.frames(2);
  panel.take(AxisSample());
  s.stage.frames(2);
  EXPECT_FALSE(s.last<intent::MoveBy>());
  EXPECT_THAT(s.toast(), HasSubstr("was not made"));
}

TEST_F(TuningTest, ARefusedStepIsToldAndIsNoRun) {
  s.click("tuning/repeat");
  panel.take(AxisSample());
  s.stage.frames(2);
  s.settle(Fate::refused, "X is off. Nothing was sent.");
  EXPECT_EQ(s.toast(), "X is off. Nothing was sent.");
  EXPECT_FALSE(s.stage.find("tuning/measure/overshoot"));
  EXPECT_EQ(s.reason("tuning/record"), "");
}

TEST_F(TuningTest, NothingRecordedIsNoResponse) {
  s.click("tuning/record");
  s.stage.frames(60 * 3);
  EXPECT_THAT(s.toast(), HasSubstr("No sample has come"));
  EXPECT_FALSE(s.stage.find("tuning/measure/overshoot"));
}

TEST_F(TuningTest, GainsOfTheChosenAxisAreSentWhenSaid) {
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
