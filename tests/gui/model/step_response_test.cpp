#include "gui/model/step_response.h"

#include <algorithm>

#include <gmock/gmock.h>

namespace hw::gui {
namespace {

StepRun recorded(int step, std::initializer_list<int> encoder) {
  StepRun run(1, AxisId{2}, Steps(step));
  int ms = 0;
  const auto take = [&](int command, int at) {
    AxisSample s;
    s.at = Instant(Millis(5000 + ms++));
    s.axis = 2;
    s.command = Steps(70 + command), s.encoder = Steps(70 + at);
    run.take(s);
  };
  for (int i = 0; i < 5; ++i) take(0, 0);
  for (const int at : encoder) take(step, at);
  return run;
}

TEST(StepResponse, TimeCountsFromTheLastMomentBeforeTheStep) {
  const StepRun run = recorded(100, {0, 50, 100});
  EXPECT_FLOAT_EQ(run.t_ms().front(), -4);
  EXPECT_FLOAT_EQ(run.t_ms()[5], 1);
  EXPECT_FLOAT_EQ(run.error()[5], 100);
}

TEST(StepResponse, Measures) {
  const StepMeasures m = measure(
      recorded(100, {0, 50, 100, 120, 110, 96, 99, 100, 100, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99}));
  EXPECT_DOUBLE_EQ(m.overshoot_percent.low, 20);
  EXPECT_DOUBLE_EQ(m.peak_ms, 4);
  EXPECT_TRUE(m.settled);
  EXPECT_DOUBLE_EQ(m.settling_ms.low, 7) << "96 was outside of 2 %";
  EXPECT_NEAR(m.rise_ms.low, 1.6, 1e-6);
  EXPECT_DOUBLE_EQ(m.steady_error.low, 1);
  EXPECT_EQ(m.crossings.low, 2) << "up through the target and back";
  EXPECT_DOUBLE_EQ(m.largest_error.low, 100);
}

TEST(StepResponse, AStepDownIsTurnedRound) {
  const StepMeasures m = measure(recorded(-100, {0, -50, -110, -100, -100}));
  EXPECT_DOUBLE_EQ(m.overshoot_percent.low, 10);
  EXPECT_TRUE(m.settled);
}

TEST(StepResponse, AStepThatDidNotSettleOrMoveReportsIt) {
  const StepMeasures m = measure(recorded(100, {0, 10, 20, 30}));
  EXPECT_FALSE(m.settled);
  EXPECT_FALSE(m.rose);
  EXPECT_DOUBLE_EQ(m.overshoot_percent.low, 0);
  EXPECT_FALSE(measure(recorded(100, {})).any);
}

TEST(StepResponse, TheOutputIsThereWhenItWasKnownAllTheTime) {
  StepRun run(1, AxisId{0}, Steps(-10));
  AxisSample s;
  s.output_known = true, s.output_percent = -61;
  run.take(s);
  s.output_percent = 20;
  run.take(s);
  ASSERT_EQ(run.output().size(), 2u);
  EXPECT_FLOAT_EQ(run.output()[0], 61) << "in the direction of the step, as all of it";
  EXPECT_FLOAT_EQ(run.largest_output(), 61);
  s.output_known = false;
  run.take(s);
  EXPECT_TRUE(run.output().empty());
}

/// 40 ms of a step of 100 that rises by 10 a ms and stays, without the samples from `from` to `to`.
StepRun recorded_but(int from, int to) {
  StepRun run(1, AxisId{2}, Steps(100));
  for (int ms = -5; ms <= 40; ++ms) {
    if (ms > from && ms < to) continue;
    AxisSample s;
    s.at = Instant(Millis(5000 + ms));
    s.axis = 2;
    s.command = Steps(ms > 0 ? 100 : 0);
    s.encoder = Steps(std::clamp(10 * ms, 0, 100));
    run.take(s);
  }
  run.end();
  return run;
}

TEST(StepResponse, WithoutAGapAllMeasuresAreExact) {
  const StepMeasures m = measure(recorded_but(0, 0));
  EXPECT_EQ(m.gaps, 0);
  EXPECT_TRUE(m.overshoot_percent.exact());
  EXPECT_TRUE(m.settling_ms.exact());
  EXPECT_DOUBLE_EQ(m.rise_ms.low, 8);
}

// On an evenly slow wire no interval is unusual, and the whole rise lies between two samples.
TEST(StepResponse, ARiseThatFewSamplesShowIsAGap) {
  StepRun run(1, AxisId{2}, Steps(100));
  for (int ms = -50; ms <= 400; ms += 25) {
    AxisSample s;
    s.at = Instant(Millis(5000 + ms));
    s.axis = 2;
    s.command = Steps(ms > 0 ? 100 : 0);
    s.encoder = Steps(std::clamp(10 * ms - 200, 0, 100));
    run.take(s);
  }
  run.end();
  const StepMeasures m = measure(run);
  EXPECT_GE(m.gaps, 1);
  EXPECT_FALSE(m.rise_ms.exact());
  EXPECT_TRUE(m.overshoot_percent.open());
  EXPECT_FALSE(m.settling_ms.exact());
}

TEST(StepResponse, AMeasureAcrossAGapIsARangeOrWithheld) {
  StepMeasures m = measure(recorded_but(7, 20));
  EXPECT_EQ(m.gaps, 1);
  EXPECT_DOUBLE_EQ(m.rise_ms.low, 6);
  EXPECT_DOUBLE_EQ(m.rise_ms.high, 19);
  EXPECT_DOUBLE_EQ(m.settling_ms.low, 7);
  EXPECT_DOUBLE_EQ(m.settling_ms.high, 20);
  EXPECT_TRUE(m.overshoot_percent.open()) << "it may have been over it unseen";
  EXPECT_TRUE(m.steady_known);
  m = measure(recorded_but(20, 30));
  EXPECT_TRUE(m.rise_ms.exact());
  EXPECT_DOUBLE_EQ(m.settling_ms.low, 10);
  EXPECT_DOUBLE_EQ(m.settling_ms.high, 30) << "it may have left the band again";
  m = measure(recorded_but(30, 39));
  EXPECT_FALSE(m.steady_known);
}

TEST(StepResponse, ARecordingThatBrokeOffHasAGapAtItsEnd) {
  StepRun run(1, AxisId{2}, Steps(100));
  for (int ms = -5; ms <= 14; ++ms) {
    AxisSample s;
    s.at = Instant(Millis(5000 + ms));
    s.axis = 2;
    s.command = Steps(ms > 0 ? 100 : 0);
    s.encoder = Steps(std::clamp(10 * ms, 0, 100));
    run.take(s);
  }
  run.end(45);
  EXPECT_TRUE(run.cut_short());
  EXPECT_FLOAT_EQ(run.planned_end_ms(), 40);
  const StepMeasures m = measure(run);
  EXPECT_EQ(m.gaps, 1);
  EXPECT_DOUBLE_EQ(m.rise_ms.low, 8);
  EXPECT_TRUE(m.rise_ms.exact()) << "that was seen";
  EXPECT_TRUE(m.overshoot_percent.open()) << "it may have gone on";
  EXPECT_DOUBLE_EQ(m.settling_ms.low, 10);
  EXPECT_TRUE(m.settling_ms.open());
  EXPECT_FALSE(m.steady_known);
}

TEST(StepResponse, AGapBeforeTheStepWidensTheSettling) {
  StepRun run(1, AxisId{2}, Steps(100));
  for (int ms = 0; ms <= 60; ++ms) {
    if (ms > 10 && ms < 30) continue;  // somewhere in there the step began
    AxisSample s;
    s.at = Instant(Millis(5000 + ms));
    s.axis = 2;
    s.command = Steps(ms >= 30 ? 100 : 0);
    s.encoder = Steps(std::clamp(10 * (ms - 29), 0, 100));
    run.take(s);
  }
  run.end(60);
  const StepMeasures m = measure(run);
  EXPECT_EQ(m.gaps, 1);
  EXPECT_DOUBLE_EQ(m.settling_ms.low, 9);
  EXPECT_DOUBLE_EQ(m.settling_ms.high, 29);
}

/// A step of `step` at 10 ms whose encoder does what `encoder` says of each ms; samples between `from` and
/// `to` are missing.
template <class Encoder>
StepRun small_step(int step, Encoder encoder, int from, int to) {
  StepRun run(1, AxisId{2}, Steps(step));
  for (int ms = 0; ms <= 40; ++ms) {
    if (ms > from && ms < to) continue;
    AxisSample s;
    s.at = Instant(Millis(5000 + ms));
    s.axis = 2;
    s.command = Steps(ms > 10 ? step : 0);
    s.encoder = Steps(encoder(ms));
    run.take(s);
  }
  return run;
}

TEST(StepResponse, ALevelReachedInAGapThatEndsWhereTheStepBeginsIsARange) {
  StepRun run = small_step(
      5, [](int ms) { return ms >= 12   ? 5
                             : ms >= 10 ? 1
                                        : 0; }, 4, 10);
  run.end(40);
  ASSERT_FLOAT_EQ(run.t_ms()[5], 0) << "the first sample behind the gap";
  const StepMeasures m = measure(run);  // 10 % of it is half a count
  ASSERT_TRUE(m.rose);
  EXPECT_FALSE(m.rise_ms.exact());
  EXPECT_GT(m.rise_ms.high, 6) << "it may have begun right behind the sample before the gap";
}

TEST(StepResponse, OfAStepWithinItsBandAllTheTimeAMissingEndIsReported) {
  StepRun run = small_step(
      1, [](int ms) { return ms > 12 ? 1 : 0; }, 0, 0);
  run.end(40);
  EXPECT_TRUE(measure(run).settled);
  EXPECT_TRUE(measure(run).settling_ms.exact());
  run.end(80);
  EXPECT_TRUE(run.cut_short());
  EXPECT_TRUE(measure(run).settling_ms.open()) << "it may have left it again";
}

TEST(StepResponse, ARecordingOfOneSampleIsCutShort) {
  StepRun run(1, AxisId{0}, Steps(10));
  run.end(40);
  EXPECT_FALSE(run.cut_short()) << "there is no recording";
  run.take(AxisSample());
  run.end(40);
  EXPECT_TRUE(run.cut_short());
  EXPECT_FLOAT_EQ(run.planned_end_ms(), 40);
}

TEST(StepScatter, IsWhatThreeRepetitionsDifferBy) {
  constexpr auto rise = [](const StepMeasures& m) { return std::optional(m.rise_ms); };
  StepScatter scatter;
  StepMeasures m;
  for (const double ms : {10.0, 12.5, 11.0}) {
    EXPECT_FALSE(scatter.of(rise));
    m.rise_ms = ms;
    scatter.take(m);
  }
  EXPECT_DOUBLE_EQ(*scatter.of(rise), 2.5);
}

TEST(StepResponse, OtherAxesAreNotMixedIn) {
  StepRun run(1, AxisId{0}, Steps(10));
  AxisSample s;
  s.axis = 1;
  run.take(s);
  EXPECT_TRUE(run.empty());
}

}  // namespace
}  // namespace hw::gui
