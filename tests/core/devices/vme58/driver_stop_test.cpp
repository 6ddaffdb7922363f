// What a stop of the VME58 ends, and what it leaves alone.
#include "core/devices/vme58/facts.h"
#include "tests/core/devices/vme58/driver_rig.h"

namespace hw {
namespace {

using test::Seconds;
using testing::HasSubstr;

class Vme58Stops : public test::Vme58Rig {
 protected:
  void hold_jog(int tenths) {
    for (int i = 0; i < tenths; ++i) {
      run(Millis(100));
      session->send(intent::JogKeepAlive());
    }
  }
  void expect_stays(int i, Duration how_long = Seconds(5)) {
    const Steps there = axis(i).position;
    run(how_long);
    EXPECT_EQ(axis(i).position, there);
    EXPECT_EQ(axis(i).speed.value, 0);
  }
};

TEST_F(Vme58Stops, AJogBesideAnothersCommandErrorDoesNotOutliveItsHand) {
  ASSERT_TRUE(query("AX VL2000 AY VL2000 HF"));
  run(Seconds(2));
  int failed = 0;
  for (int before_ms = 10; before_ms < 360; before_ms += 50) {
    perform(intent::SendText("AY WT350 MR100 GO WQ"));  // MR is rejected at its turn, and WQ holds the ring
    run(Millis(before_ms));
    const IntentId jog = session->send(intent::JogStart(AxisId{0}, Sign::plus));
    hold_jog(9);
    failed += now().outcome_of(jog)->state == IntentState::failed;
    EXPECT_NE(axis(0).ended_by, EndedBy::elsewhere);
    session->send(intent::JogStop());
    run(Seconds(1));
    expect_stays(0);
  }
  EXPECT_GT(failed, 0);
}

// ---- of one axis

constexpr const char* there_and_back = "MT20000,20000; GO\nMT0,0; GO\nMT20000,20000; GO\nMT0,0; GO\n";

TEST_F(Vme58Stops, OneAxisOfAProgramIsStoppedForGood) {
  for (const char* mode : {"AA", "AM"}) {
    const std::string text = std::string(mode) + " VL20000,20000; AC100000,100000;\n" + there_and_back;
    ASSERT_EQ(perform(intent::LoadProgram(0, text)).state, IntentState::done);
    ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
    run(Millis(500));
    ASSERT_EQ(axis(0).activity, Activity::moving);
    EXPECT_EQ(perform(intent::Stop(0)).state, IntentState::done);
    expect_stays(0);
    EXPECT_EQ(now().program.run, RunState::idle);
    EXPECT_THAT(reported(), HasSubstr("all axes were stopped"));
    perform(intent::MoveTo({{AxisId{0}, Steps(0)}, {AxisId{1}, Steps(0)}}));
    ASSERT_TRUE(becomes_idle());
  }
}

TEST_F(Vme58Stops, TypedItEndsTheProgramThatIsStillFed) {
  std::string text = "AX VL1000 AC10000\n";
  for (int i = 0; i < 200; ++i) text += "MR200 GO\n";
  for (const char* stop : {"SA", "KL", "AX ST"}) {
    ASSERT_EQ(perform(intent::LoadProgram(0, text)).state, IntentState::done);
    ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
    run(Millis(1500));
    ASSERT_EQ(now().program.run, RunState::running);
    EXPECT_EQ(perform(intent::SendText(stop)).state, IntentState::done) << stop;
    ASSERT_TRUE(becomes_idle()) << stop;
    expect_stays(0);
    EXPECT_EQ(now().program.run, RunState::idle) << stop;
  }
}

TEST_F(Vme58Stops, OneAxisThatATextMovesWithOthersIsStoppedForGood) {
  ASSERT_TRUE(query(std::string("AA VL20000,20000; AC100000,100000; ") + there_and_back));
  run(Millis(500));
  EXPECT_EQ(perform(intent::Stop(0)).state, IntentState::done);
  expect_stays(0);
  ASSERT_TRUE(query("AM WT1000; MR500,500; GO"));
  EXPECT_EQ(perform(intent::Stop(0)).state, IntentState::done) << "it waits in the queue";
  expect_stays(0);
}

TEST_F(Vme58Stops, OneAxisThatATextMovedBeforeTheLinkWasLostIsStoppedForGood) {
  ASSERT_TRUE(query(std::string("AA VL2000,2000; AC100000,100000; ") + there_and_back));
  run(Millis(500));
  operate(bench::Unplug(true));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, Seconds(20)));
  operate(bench::Unplug(false));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(20)));
  EXPECT_EQ(perform(intent::Stop(0)).state, IntentState::done);
  expect_stays(0);
}

TEST_F(Vme58Stops, OneAxisThatAnEarlierTextHasPreparedIsStoppedForGood) {
  ASSERT_TRUE(query("AX VL2000 AC100000 AY VL2000 AC100000"));
  for (const char* mode : {"AA ", "AM "})
    for (const char* go : {"GO", "GD"}) {
      ASSERT_TRUE(query(std::string(mode) + "MR3000,3000;"));
      run(Seconds(1));
      ASSERT_TRUE(query(std::string("WT1500 ") + go));
      run(Millis(500));
      EXPECT_EQ(perform(intent::Stop(0)).state, IntentState::done);
      expect_stays(0);
    }
  ASSERT_EQ(perform(intent::LoadProgram(0, "AA MR3000,3000;")).state, IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  ASSERT_TRUE(becomes_idle());
  ASSERT_TRUE(query("AA WT1500 GO"));
  EXPECT_EQ(perform(intent::Stop(0)).state, IntentState::done);
  expect_stays(0);
}

TEST_F(Vme58Stops, OneAxisStopsAloneAfterAContour) {
  for (const char* end : {"CE", "CK", "AA"}) {
    ASSERT_TRUE(query("AA VL2000,2000; CV1000 CD0,0; MT1000,1000;"));
    run(Seconds(3));
    (void)query(end);
    run(Seconds(2));
    for (const std::uint8_t i : {0, 1}) perform(intent::MoveBy({{AxisId{i}, Steps(100000)}}, Pps{2000}));
    run(Millis(500));
    EXPECT_EQ(perform(intent::Stop(0)).state, IntentState::done);
    EXPECT_EQ(axis(0).activity, Activity::idle) << end;
    EXPECT_EQ(axis(1).activity, Activity::moving) << end;
    perform(intent::Stop());
    ASSERT_TRUE(becomes_idle());
  }
}

TEST_F(Vme58Stops, OneAxisOfItsOwnStopsAlone) {
  perform(intent::MoveBy({{AxisId{1}, Steps(100000)}}, Pps{2000}));
  ASSERT_TRUE(query("AX VL2000 MR5000 GO MR-5000 GO AA MR,,5000,5000; GO AM WT500; MR,,,,100; GO"));
  run(Millis(500));
  EXPECT_EQ(perform(intent::Stop(0)).state, IntentState::done);
  expect_stays(0, Seconds(1));
  EXPECT_EQ(axis(1).activity, Activity::moving);
  EXPECT_GT(axis(2).position, Steps(0));
  EXPECT_EQ(axis(4).position, Steps(100));
}

TEST_F(Vme58Stops, TwoAxesThatAreStoppedOneAfterTheOtherRamp) {
  ASSERT_TRUE(query("AX VL20000 AC20000 AY VL20000 AC20000 AZ VL20000 AC20000"));
  for (const std::uint8_t i : {0, 1, 2}) perform(intent::MoveBy({{AxisId{i}, Steps(1000000)}}));
  run(Seconds(2));
  session->send(intent::Stop(0));
  session->send(intent::Stop(1));
  run(Millis(300));
  EXPECT_EQ(axis(0).activity, Activity::stopping);
  EXPECT_EQ(axis(1).activity, Activity::stopping);
  EXPECT_NEAR(axis(2).speed.value, 20000, 1);
  run(Seconds(2));
  EXPECT_EQ(axis(1).ended_by, EndedBy::stop);
  EXPECT_EQ(axis(2).activity, Activity::moving);
}

TEST_F(Vme58Stops, AMotionBegunBehindAJogGoesOnWhenTheJogIsReleased) {
  ASSERT_TRUE(query("AX VL20000 AC5000 AY VL10000 AC100000"));
  session->send(intent::JogStart(AxisId{0}, Sign::plus, Pps{5000}));
  hold_jog(9);
  session->send(intent::SendText("AY MR6000 GO AA CV3000 CD0,0; MT3000,3000; CK CX"));  // waits for both axes
  hold_jog(1);
  (void)reported();
  EXPECT_EQ(perform(intent::JogStop()).state, IntentState::done);
  run(Millis(100));
  EXPECT_EQ(axis(0).activity, Activity::moving) << "and jogs no more";
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).position, Steps(3000));
  EXPECT_EQ(axis(1).position, Steps(3000));
  EXPECT_EQ(reported(), "");
}

TEST_F(Vme58Stops, AnAbortRightBehindAStopFindsTheMailboxFree) {
  ASSERT_TRUE(query("AX VL20000 AC2000"));
  perform(intent::MoveBy({{AxisId{0}, Steps(1000000)}}));
  run(Seconds(11));
  session->send(intent::Stop());
  session->send(intent::Abort());
  run(Millis(200));
  EXPECT_THAT(lines(), testing::IsSupersetOf({"> mailbox SA", "> mailbox KL"}));
  EXPECT_EQ(axis(0).speed.value, 0) << "no ramp of ten seconds";
}

// ---- in the board's own words

TEST_F(Vme58Stops, ATypedOneGoesPastAFullQueueAndWhatWaits) {
  for (const char* stop : {"SA", "KL", "SD", "AX ST"})
    for (const bool asked : {false, true}) {
      ASSERT_TRUE(query("AX VL20000 AC40000 MR1000000 GO"));
      std::string many;
      for (int i = 0; i < 150; ++i) many += "WT1 ";
      (void)query(many);  // more than the queue holds: the rest waits in the ring
      run(Seconds(1));
      ASSERT_NEAR(axis(0).speed.value, 20000, 1);
      for (int i = 0; i < 5; ++i) session->send(intent::SendText("MR777 GO"));
      run(Millis(1));
      (void)lines();
      const Instant then = time.now();
      if (asked)
        EXPECT_TRUE(query(stop));
      else
        EXPECT_EQ(perform(intent::SendText(stop)).state, IntentState::done);
      EXPECT_LT(time.now() - then, Millis(50)) << stop;
      run(Millis(150));
      const bool kills = std::string_view(stop) == "KL";
      EXPECT_EQ(axis(0).speed.value == 0, kills) << stop;
      run(Millis(500));
      expect_stays(0);
      const std::string word = std::string_view(stop) == "AX ST" ? "SA" : stop;
      EXPECT_THAT(lines(), testing::Contains("> mailbox " + word));
      ASSERT_TRUE(becomes_idle());
    }
}

TEST_F(Vme58Stops, ATypedOneOfOneAxisLeavesTheOthers) {
  ASSERT_TRUE(query("AX VL20000 AC40000 MR1000000 GO AY VL20000 AC40000 MR1000000 GO"));
  run(Seconds(1));
  for (int i = 0; i < 5; ++i) session->send(intent::SendText("AX RP AY RP"));
  EXPECT_EQ(perform(intent::SendText("AX ST")).state, IntentState::done);
  run(Seconds(1));
  expect_stays(0, Seconds(1));
  EXPECT_NEAR(axis(1).speed.value, 20000, 1);
  EXPECT_THAT(lines(), testing::Contains("> AX ST"));
}

class Vme58SlowBusStops : public Vme58Stops {
 protected:
  std::unique_ptr<Window> dressed(std::unique_ptr<Window> window) override {
    return std::make_unique<test::SlowBus>(time, std::move(window));
  }
};

TEST_F(Vme58SlowBusStops, ATypedOneSelectsWhatItNamesWhateverItOvertakes) {
  ASSERT_TRUE(query("AX VL20000 AC1000000 AY VL20000 AC1000000 AZ VL20000 AC1000000"));
  run(Seconds(1));
  for (const char* stop : {"AX ST", "AX SA", "KL AX", "AY ST AX ST"})
    for (int after_us = 0; after_us < 6000; after_us += 70) {
      ASSERT_TRUE(query("AZ"));
      session->send(intent::SendText("AY MR10000 GO AZ"));
      run(std::chrono::microseconds(after_us));
      EXPECT_EQ(perform(intent::SendText(stop)).state, IntentState::done);
      run(Millis(50));
      const Steps x = axis(0).position, y = axis(1).position, z = axis(2).position;
      ASSERT_TRUE(query("MR100 GO"));
      ASSERT_TRUE(becomes_idle());
      ASSERT_EQ(axis(0).position, x + Steps(100)) << stop << ' ' << after_us;
      EXPECT_TRUE(std::string_view(stop) == "AX ST" || axis(1).position == y) << stop << ' ' << after_us;
      ASSERT_EQ(axis(2).position, z) << stop << ' ' << after_us;
    }
}

// What the board took before the stop may have selected: then both stand where the text left them, or where
// the console believes, but never apart.
TEST_F(Vme58SlowBusStops, BehindOneTheBoardAndTheConsoleStandAtTheSameAxis) {
  ASSERT_TRUE(query("AX VL20000 AC1000000 AY VL20000 AC1000000 AZ VL20000 AC1000000"));
  run(Seconds(1));
  const auto moved = [&] {
    const Steps x = axis(0).position, y = axis(1).position;
    EXPECT_TRUE(query("MR50 GO"));
    EXPECT_TRUE(becomes_idle());
    return std::array{axis(0).position != x, axis(1).position != y};
  };
  for (const char* stop : {"SA", "KL", ""})
    for (int after_us = 0; after_us < 6000; after_us += 110) {
      ASSERT_TRUE(query("AX"));
      session->send(intent::SendText("AY MR1000 GO"));
      run(std::chrono::microseconds(after_us));
      if (*stop)
        perform(intent::SendText(stop));
      else
        perform(intent::Stop());
      ASSERT_TRUE(becomes_idle());
      const auto first = moved();
      perform(
          intent::MoveBy({{AxisId{2}, Steps(10)}}));  // selects, and goes back to what the user had selected
      ASSERT_TRUE(becomes_idle());
      ASSERT_EQ(moved(), first) << stop << ' ' << after_us;
    }
}

TEST_F(Vme58Stops, ATypedOneOfAllLeavesARecordingOpen) {
  ASSERT_TRUE(query("AA VL5000,5000; CV1000 CD0,0; MT1000,1000;"));
  EXPECT_EQ(perform(intent::SendText("SA")).state, IntentState::done);
  EXPECT_NE(perform(intent::SetOutput(8, true)).state, IntentState::done);
  ASSERT_TRUE(query("CK CX"));
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).position, Steps(1000));
  EXPECT_EQ(axis(1).position, Steps(1000));
}

// ---- what is stopped beside the axes

TEST_F(Vme58Stops, ARecordingEndsOnTheBoardToo) {
  ASSERT_TRUE(query("AA VL5000,5000; CV1000 CD0,0; MT1000,1000;"));
  session->send(intent::Stop());
  EXPECT_EQ(perform(intent::SetOutput(8, true)).state, IntentState::done);
  EXPECT_EQ(peek(1, vme58::reg::io_high) & 1, 0u);
  ASSERT_TRUE(query("CD0,0; MT1000,1000;"));
  session->send(intent::Stop());
  EXPECT_TRUE(query("MT500,500; GO"));
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).position, Steps(500));
  EXPECT_EQ(axis(1).position, Steps(500));
}

}  // namespace
}  // namespace hw
