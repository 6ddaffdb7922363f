// At which speed an axis of the VME58 goes when nobody names one, and that a speed that was chosen for one
// motion is that one's only.
#include "core/devices/vme58/facts.h"
#include "tests/core/devices/vme58/driver_rig.h"

namespace hw {
namespace {

using test::Seconds;

class Vme58Speeds : public test::Vme58Rig {
 protected:
  static std::string name(int i) { return std::string(1, vme58::axis_letters[static_cast<std::size_t>(i)]); }
  /// VL as the board has it.
  std::int64_t on_board(int i) {
    run(Seconds(3));
    return static_cast<std::int32_t>(peek(4, vme58::offset_of(i, vme58::AxisValue::maximum_velocity)));
  }
  IntentOutcome step(std::uint8_t i, std::int64_t counts, Pps speed) {
    return perform(intent::MoveBy({{AxisId{i}, Steps(counts)}}, speed));
  }
};

TEST_F(Vme58Speeds, AJogGoesAtTheSpeedThatWasSetAMomentAgo) {
  for (std::uint8_t i = 0; i < 8; ++i) {
    ASSERT_TRUE(query("A" + name(i) + " VL500"));
    session->send(intent::JogStart(AxisId{i}, Sign::plus, Pps{}, false));
    run(Millis(300));
    EXPECT_NEAR(axis(i).speed.value, 500, 1) << name(i);
    perform(intent::Stop());
  }
  ASSERT_EQ(perform(intent::LoadProgram(0, "AX VL700")).state, IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  ASSERT_TRUE(run_until([this] { return now().program.run == RunState::idle; }, Seconds(5)));
  session->send(intent::JogStart(AxisId{0}, Sign::plus, Pps{}, false));
  run(Millis(300));
  EXPECT_NEAR(axis(0).speed.value, 700, 1);
}

TEST_F(Vme58Speeds, TheSpeedOfAShortStepIsGivenBack) {
  for (std::uint8_t i = 0; i < 8; ++i)
    ASSERT_EQ(perform(intent::SetParam("VL" + name(i), 100)).state, IntentState::done);
  for (std::uint8_t i = 0; i < 8; ++i) {
    EXPECT_EQ(step(i, 10, Pps{500}).state, IntentState::done);
    EXPECT_EQ(on_board(i), 100) << name(i);
  }
  ASSERT_TRUE(query("AX VL200"));
  EXPECT_EQ(step(0, 10, Pps{500}).state, IntentState::done);
  EXPECT_EQ(on_board(0), 200) << "set a moment before";
}

TEST_F(Vme58Speeds, TheSpeedOfAStepIsGivenBackBehindALostLinkToo) {
  for (const bool anothers : {false, true}) {
    ASSERT_EQ(perform(intent::SetParam("VLX", 2000)).state, IntentState::done);
    EXPECT_EQ(step(0, 300, Pps{500}).state, IntentState::done);
    operate(bench::Unplug(true));
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, Seconds(20)));
    operate(bench::Unplug(false));
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(20)));
    if (anothers) {
      ASSERT_EQ(perform(intent::SetParam("VLX", 700)).state, IntentState::done);
    }
    EXPECT_EQ(on_board(0), anothers ? 700 : 2000);
  }
}

TEST_F(Vme58Speeds, ASpeedSetDuringAStepStays) {
  ASSERT_EQ(step(0, 300, Pps{500}).state, IntentState::done);
  ASSERT_EQ(perform(intent::SetParam("VLX", 5000)).state, IntentState::done);
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(on_board(0), 5000);
  ASSERT_EQ(step(0, 300, Pps{500}).state, IntentState::done);
  ASSERT_TRUE(query("AX VL6000"));
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(on_board(0), 6000);
  ASSERT_EQ(step(0, 300, Pps{500}).state, IntentState::done);
  ASSERT_TRUE(query("AA VL7000,8000;"));
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(on_board(0), 7000);
  EXPECT_EQ(on_board(1), 8000);
}

TEST_F(Vme58Speeds, ASpeedWaitingInAQueueIsRestoredToo) {
  for (const char* text : {"AX MR3000 GO ID VL500", "AX WT3000 VL500", "AX MR3000 GO ID"}) {
    const bool by_param = !std::string_view(text).ends_with("VL500");
    ASSERT_TRUE(query("AX VL1000 AC1000000"));
    run(Seconds(1));
    ASSERT_TRUE(query(text));
    run(Seconds(1));
    if (by_param) {
      ASSERT_EQ(perform(intent::SetParam("VLX", 500)).state, IntentState::done);
    }
    run(Millis(100));
    EXPECT_EQ(axis(0).own_speed.value, 500) << "of what comes next";
    for (int i = 0; i < 3; ++i) {
      step(0, 300, Pps{1500});
      run_until([this] { return axis(0).activity == Activity::idle; }, Seconds(10));
    }
    ASSERT_TRUE(becomes_idle());
    EXPECT_EQ(on_board(0), 500) << text;
    EXPECT_EQ(axis(0).own_speed.value, 500) << text;
  }
}

TEST_F(Vme58Speeds, ASpeedThatAStopTookOutOfAQueueIsNotRestored) {
  for (const char* how : {"", "AX FL", "SA"}) {
    ASSERT_TRUE(query("AX VL1000 AC1000000"));
    run(Seconds(1));
    ASSERT_TRUE(query("AX MR3000 GO ID VL500"));
    run(Seconds(1));
    EXPECT_EQ(step(0, 300, Pps{1500}).state, IntentState::done);
    if (*how == 0)
      perform(intent::Stop());
    else
      ASSERT_TRUE(query(how));
    run(Seconds(1));
    perform(intent::Stop());
    EXPECT_EQ(on_board(0), 1000) << how;
    EXPECT_EQ(axis(0).own_speed.value, 1000) << how;
  }
}

TEST_F(Vme58Speeds, AMoveByTextBehindAStepGoesAtTheAxisOwnSpeed) {
  for (const char* text : {"AX MR100000 GO", "AA MR100000; GO", "AX LS2 MR50000 GO LE", "AX"}) {
    ASSERT_TRUE(query("AX VL1000 AC1000000"));
    run(Seconds(1));
    EXPECT_EQ(step(0, 3000, Pps{3000}).state, IntentState::done);
    ASSERT_TRUE(query("AX RP"));
    ASSERT_TRUE(query(text));
    run(Millis(100));
    if (std::string_view(text) == "AX") {
      ASSERT_TRUE(query("MR100000 GO"));
    }
    run(Millis(400));
    EXPECT_NEAR(axis(0).speed.value, 3000, 10) << "the step itself is as it was";
    run(Seconds(2));
    EXPECT_NEAR(axis(0).speed.value, 1000, 1) << text;
    ASSERT_TRUE(query("AX VL1200"));
    perform(intent::Stop());
    EXPECT_EQ(on_board(0), 1000) << "the other one was taken out of the queue";
  }
}

TEST_F(Vme58Speeds, AStepThatIsStoppedBeforeTheTextBehindItGivesItsSpeedBack) {
  ASSERT_TRUE(query("AX VL1000 AC1000000"));
  run(Seconds(1));
  EXPECT_EQ(step(0, 30000, Pps{3000}).state, IntentState::done);
  ASSERT_TRUE(query("AX MR100000 GO"));
  run(Millis(400));
  perform(intent::Stop());
  EXPECT_EQ(on_board(0), 1000);
}

TEST_F(Vme58Speeds, AJogBehindASpeedThatStillWaitsGoesAtThat) {
  ASSERT_TRUE(query("AX VL1000 AC1000000"));
  run(Seconds(1));
  ASSERT_TRUE(query("AX MR1000 GO ID VL500"));
  run(Millis(500));
  session->send(intent::JogStart(AxisId{0}, Sign::plus, Pps{}, false));
  run(Seconds(2));
  EXPECT_NEAR(axis(0).speed.value, 500, 1);
}

TEST_F(Vme58Speeds, AMotionRightBehindAStopGoesAtTheAxisOwnSpeed) {
  ASSERT_TRUE(query("AX VL2000 AC100000"));
  ASSERT_EQ(perform(intent::LoadProgram(0, "AX MR100000 GO")).state, IntentState::done);
  const auto behind_a_stop = [this](IntentBody body) {
    EXPECT_EQ(step(0, 100000, Pps{20000}).state, IntentState::done);
    run(Millis(500));
    session->send(intent::Stop());
    session->send(std::move(body));
    run(Seconds(2));
    const double speed = axis(0).speed.value;
    perform(intent::Stop());
    return speed;
  };
  EXPECT_NEAR(behind_a_stop(intent::MoveBy({{AxisId{0}, Steps(100000)}})), 2000, 1);
  EXPECT_NEAR(behind_a_stop(intent::Home(AxisId{0}, Sign::plus, 2)), 2000, 1);
  EXPECT_NEAR(behind_a_stop(intent::SendText("MR100000 GO")), 2000, 1);
  EXPECT_NEAR(behind_a_stop(intent::RunProgram(0)), 2000, 1);
}

}  // namespace
}  // namespace hw
