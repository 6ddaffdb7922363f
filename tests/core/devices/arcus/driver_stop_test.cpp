// Stops that have to reach more than what the console has seen run: programs that others start, axes that a
// program gave to the joystick, lines on which answers are lost.
#include "tests/core/devices/arcus/driver_fixture.h"

namespace hw::arcus {
namespace {

using testing::HasSubstr;

class Stopping : public DriverTest {
 protected:
  static constexpr const char* pmx = "pmx-4ex-sa";
  static constexpr const char* dmx = "dmx-k-sa";
  const std::string to_and_fro = "ABS\nWHILE 1=1\nX2000\nWAITX\nX0\nWAITX\nENDWHILE\nEND\n";
  const std::string endless = "WHILE 1=1\nV1=V1+1\nDELAY=10\nENDWHILE\nEND\n";
  std::string load(std::string text) { return perform(intent::LoadProgram(0, std::move(text))); }
  /// Nothing moves, and nothing begins to.
  bool stays() {
    const auto there = query("PX");
    run(1.5);
    return query("PX") == there;
  }
  void next() {
    TearDown();
    latest = Snapshot();
    notices.clear();
  }
};

TEST_F(Stopping, EndsAProgramThatAProgramHasStarted) {
  for (const double after : {0.05, 0.1, 0.3, 0.7}) {
    start(pmx, {}, true);
    ASSERT_EQ(load("PRG 0\nSR3=1\nDELAY=1\nEND\nPRG 3\n" + to_and_fro), "");
    run(2);
    ASSERT_EQ(perform(intent::RunProgram(0)), "");
    run(after);
    EXPECT_EQ(perform(intent::Stop()), "");
    EXPECT_EQ(latest.threads[3].run, RunState::idle);
    EXPECT_EQ(query("SASTAT3"), "0") << after;
    EXPECT_TRUE(stays()) << after;
    next();
  }
}

// Each starts the other, so that one that was halted runs again before the other is.
TEST_F(Stopping, EndsTwoProgramsThatStartEachOther) {
  for (const char* model : {pmx, dmx}) {
    start(model, {}, true);
    ASSERT_EQ(
        load("PRG 0\nWHILE 1=1\nSR1=1\nENDWHILE\nEND\nPRG 1\nWHILE 1=1\nSR0=1\nX1000\nWAITX\nX0\nWAITX\n"
             "ENDWHILE\nEND\n"),
        "");
    ASSERT_EQ(perform(intent::RunProgram(0)), "");
    run(1);
    const std::string sentence = perform(intent::Stop());
    const bool ended = query("SASTAT0") == "0" && query("SASTAT1") == "0";
    EXPECT_EQ(ended, sentence.empty()) << sentence;
    EXPECT_TRUE(ended || testing::Value(sentence, HasSubstr("is still running"))) << sentence;
    next();
  }
}

TEST_F(Stopping, EndsAProgramWhoseStartWasNotConfirmed) {
  for (const double rested : {3.0, 3.05, 3.1, 3.15, 3.2}) {
    start(pmx);
    ASSERT_EQ(load("PRG 0\nDELAY=1\nEND\nPRG 3\n" + to_and_fro), "");
    run(rested);
    loop->drop(3);
    EXPECT_NE(perform(intent::RunProgram(3)), "");
    EXPECT_FALSE(latest.threads[3].known);
    EXPECT_EQ(perform(intent::Stop()), "");
    EXPECT_EQ(query("SASTAT3"), "0") << rested;
    EXPECT_TRUE(stays()) << rested;
    next();
  }
}

TEST_F(Stopping, EndsAProgramThatTheControllerStartsWhenItsPowerComesBack) {
  for (const double rested : {2.05, 2.25, 2.45, 2.65}) {  // another thread is looked at each time
    start(pmx);
    ASSERT_EQ(load("PRG 0\nDELAY=1\nEND\nPRG 2\nDELAY=50\n" + to_and_fro), "");
    ASSERT_EQ(perform(intent::SetParam("SLOAD", 4)), "");
    ASSERT_EQ(perform(intent::Store()), "");
    run(rested);
    ASSERT_TRUE(loop->operate(bench::PowerCycle()));
    run(0.1);
    EXPECT_EQ(perform(intent::Stop()), "");
    EXPECT_EQ(query("SASTAT2"), "0") << rested;
    EXPECT_TRUE(stays()) << rested;
    next();
  }
}

// ---- the joystick

TEST_F(Stopping, TakesAnAxisFromTheJoystickThatAProgramGaveIt) {
  start(pmx);
  ASSERT_TRUE(loop->operate(bench::Analog(1, 2500)));
  ASSERT_EQ(perform(intent::SetParam("JV1", 1000, true)), "");
  ASSERT_EQ(perform(intent::SetParam("JV5", 1000, true)), "");
  run(40);  // everything is known
  ASSERT_EQ(load("JOYENA=1\nWHILE 1=1\nDELAY=100\nENDWHILE\nEND\n"), "");
  ASSERT_TRUE(loop->operate(bench::Analog(1, 5000)));
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  run(2);
  ASSERT_TRUE(latest.any_axis_moving());
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_EQ(query("JE"), "0");
  EXPECT_TRUE(stays());
}

TEST_F(Stopping, OfOneAxisLeavesTheOthersTheirJoystick) {
  start(pmx);
  ASSERT_EQ(query("JE=3"), "OK");
  EXPECT_EQ(perform(intent::Stop(1)), "");
  EXPECT_EQ(query("JE"), "1");
  EXPECT_TRUE(reported("joystick was switched off"));
}

TEST_F(Stopping, WithoutAJoystickChangesNoSetting) {
  start(pmx);
  sent();
  EXPECT_EQ(perform(intent::Stop(1)), "");
  EXPECT_EQ(sent(), "STOPY") << "not known yet, and asked";
  EXPECT_FALSE(latest.unsaved_setup);
}

// ---- answers that are lost

TEST_F(Stopping, ReachesTheProgramsAlsoWhereItsAnswersAreLost) {
  for (const int lost : {3, 6, 9, 12, 15, 18, 21}) {
    start(pmx);
    ASSERT_EQ(load(to_and_fro), "");
    run(3);
    ASSERT_EQ(perform(intent::RunProgram(0)), "");
    run(1.005);
    loop->drop(lost);
    EXPECT_EQ(perform(intent::Stop()), "") << lost;
    EXPECT_EQ(query("SASTAT0"), "0") << lost;
    EXPECT_TRUE(stays()) << lost;
    next();
  }
}

TEST_F(Stopping, SendsEverythingOnceBeforeASilentLineIsGivenUp) {
  for (const bool byte_times : {false, true}) {
    start(pmx, {}, byte_times);
    ASSERT_EQ(load(to_and_fro), "");
    ASSERT_EQ(perform(intent::RunProgram(0)), "");
    run(1);
    loop->drop(1 << 20);
    const auto before = loop->to_controller.size();
    EXPECT_THAT(perform(intent::Stop()), HasSubstr("Stop was sent, but the controller does not answer"));
    EXPECT_THAT(loop->to_controller.substr(before),
                testing::StartsWith("@00STOP\r~\r@00SR0=0\r~\r@00STOP\r~\r@00SR1=0\r~\r@00SR2=0\r"
                                    "~\r@00SR3=0\r~\r@00STOP\r"))
        << "first the program that runs";
    next();
  }
}

// ---- a jog that ends

TEST_F(Stopping, AJogThatEndsLeavesTheProgramsOfBothModels) {
  for (const char* model : {pmx, dmx}) {
    start(model);
    ASSERT_EQ(load("PRG 0\nDELAY=1\nEND\nPRG 1\n" + endless), "");
    ASSERT_EQ(perform(intent::RunProgram(1)), "");
    ASSERT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus)), "");
    hold(10);
    ASSERT_EQ(latest.axes[0].activity, Activity::jogging);
    EXPECT_EQ(perform(intent::JogStop()), "");
    EXPECT_EQ(latest.axes[0].activity, Activity::idle);
    EXPECT_EQ(query("SASTAT1"), "1") << model;
    EXPECT_TRUE(stays());
    next();
  }
}

// ---- the user's own words

TEST_F(Stopping, TypedItEndsTheListOfMoves) {
  for (const char* text : {"STOP", "ABORT", "@00STOP"})
    for (const int lost : {0, 3}) {
      start(pmx);
      std::vector<std::vector<std::int64_t>> rows(100, {0, 0, 0, 500});
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i][0] = static_cast<std::int64_t>(i + 1) * 100;
      ASSERT_EQ(perform(intent::FeedMoves(rows)), "");
      run(2);
      ASSERT_TRUE(latest.feed.running);
      loop->drop(lost);
      query(text);
      run(1);
      EXPECT_FALSE(latest.feed.running) << text << lost;
      EXPECT_TRUE(stays()) << text << lost;
      next();
    }
}

}  // namespace
}  // namespace hw::arcus
