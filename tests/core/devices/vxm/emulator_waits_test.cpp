// Waits and the multifunction inputs (p.22; App. B, C, H, T; setI).
#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {
namespace {

Rig waiting(const std::string& setup, const std::string& program) {
  Rig rig = Rig::online();
  rig.send(setup);
  rig.send(program + "R");
  rig.run_for(1s);
  rig.output();
  return rig;
}

}  // namespace

TEST(VxmWaits, TheLowTimeOfInputOneCanBeShortened) {
  for (const auto& [setup, valid] : {std::pair{"setI7,", Duration(1ms)}, {"setI15,", Duration(100us)}}) {
    Rig rig = waiting(setup, "U0,");
    rig.input(1, true);
    rig.run_for(valid - 10us);
    EXPECT_TRUE(is_busy(rig)) << setup;
    rig.run_for(20us);
    EXPECT_FALSE(is_busy(rig)) << setup;
  }
}

TEST(VxmWaits, OutputOneReturnsToItsLevel) {
  for (const char* wait : {"U1,", "U31,", "U51,"}) {
    Rig rig = waiting("", std::string("U5,") + wait + "P10,");
    EXPECT_TRUE(rig.out(1));
    rig.pulse_input(1);
    EXPECT_TRUE(rig.out(1)) << wait << "it was high before (V70)";
    EXPECT_TRUE(rig.run_until_output("^", 5s));
  }
}

TEST(VxmWaits, KillEndsAWaitWithItsOutput) {
  Rig rig = waiting("", "U1,");
  EXPECT_TRUE(rig.out(1));
  EXPECT_EQ(rig.ask("K"), "^");
  EXPECT_FALSE(rig.out(1));
  Rig pause = waiting("", "PA100,");
  EXPECT_EQ(pause.ask("K"), "^");
  EXPECT_FALSE(pause.out(1));
  pause.run_for(1min);
  EXPECT_EQ(pause.output(), "");
}

TEST(VxmWaits, InputThreeBranchesUserWaitsToProgramThree) {
  for (const char* wait :
       {"U0,", "U1,", "U30,", "U31,", "U32,", "U33,", "U50,", "U51,", "U90,", "U13,", "U23,"}) {
    Rig rig = waiting("PM3,I1M7,PM0,", std::string(wait) + "I1M100,");
    rig.input(3, true);
    EXPECT_TRUE(rig.run_until_output("^", 10s)) << wait;
    EXPECT_EQ(rig.position(1), 7) << wait << ": a jump, not a call (V73)";
    EXPECT_FALSE(rig.out(1)) << wait;
  }
}

TEST(VxmWaits, InputThreeLeavesPausesAndTheHostAlone) {
  Rig pause = waiting("PM3,I1M7,PM0,", "P50,I1M100,");
  pause.input(3, true);
  EXPECT_TRUE(pause.run_until_output("^"));
  EXPECT_EQ(pause.position(1), 100);
  Rig host = waiting("PM3,I1M7,PM0,", "U6,I1M100,");
  host.input(3, true);
  host.run_for(1s);
  EXPECT_TRUE(is_busy(host));
  host.send("G");
  EXPECT_TRUE(host.run_until_output("^"));
  EXPECT_EQ(host.position(1), 100);
}

TEST(VxmWaits, TheBranchCanBeSwitchedOff) {
  Rig rig = waiting("setI3,PM3,I1M7,PM0,", "U0,I1M100,");
  rig.input(3, true);
  rig.run_for(1s);
  EXPECT_TRUE(is_busy(rig));
}

TEST(VxmWaits, InputsTwoAndThreeSelectTheProgram) {
  struct Switch {
    bool input_3, input_2;
    std::int64_t moved;
  };
  // App. C: the binary switch, 1 = high.
  for (const Switch& s : {Switch{false, false, 1}, Switch{false, true, 10}, Switch{true, false, 100},
                          Switch{true, true, 1000}}) {
    Rig rig = Rig::online();
    rig.send("I1M1,PM1,I1M10,PM2,I1M100,PM3,I1M1000,PM0,setI67,");
    EXPECT_EQ(rig.ask("getI"), "67\r");
    rig.send("Q");
    rig.input(2, s.input_2);
    rig.input(3, s.input_3);
    rig.click("Run");
    rig.run_for(10s);
    EXPECT_EQ(rig.load(1), s.moved);
  }
}

TEST(VxmWaits, TheRunButtonRunsInLocalModeAndOnline) {
  Rig rig = Rig::online();
  rig.send("I1M4,Q");
  rig.click("Run");
  rig.run_for(5s);
  EXPECT_EQ(rig.load(1), 4);
  EXPECT_EQ(rig.output(), "^") << "always (V16)";
  rig.send("F");
  rig.click("Run");
  EXPECT_TRUE(rig.run_until_output("^", 5s));
  EXPECT_EQ(rig.load(1), 8);
  rig.output();
  rig.send("PM2,I1M100,");
  rig.click("Run");
  EXPECT_TRUE(rig.run_until_output("^", 5s));
  EXPECT_EQ(rig.load(1), 108) << "the selected program, as R";
}

TEST(VxmWaits, RunHeldDownRunsOnceOrAgainButNeverStalls) {
  Rig rig = Rig::online();
  rig.send("I1M4,");
  rig.press("Run");
  EXPECT_TRUE(rig.run_until_output("^", 5s));
  rig.release("Run");
  rig.run_for(5s);
  rig.output();
  EXPECT_EQ(rig.ask("V"), "R");
}

TEST(VxmWaits, StopEndsTheProgramInAControlledManner) {
  Rig rig = Rig::online();
  rig.send("U5,I1M100000,I2M9,R");
  rig.run_for(3s);
  rig.press("Stop");
  rig.run_for(900ms);
  rig.release("Stop");
  const std::string report = rig.output();
  EXPECT_TRUE(is_busy(rig)) << "it ramps down";
  EXPECT_TRUE(rig.run_until_output("^", 1s));
  rig.run_for(10s);
  EXPECT_EQ(report + rig.output(), "ES^");
  EXPECT_NEAR(static_cast<double>(rig.position(1)), 6000, 5);
  EXPECT_EQ(rig.position(2), 0) << "the program is over (App. T)";
  EXPECT_NEAR(std::atof(rig.ask("*").c_str()), 5000, 5);
}

TEST(VxmWaits, InputFourIsTheStopButton) {
  Rig rig = waiting("", "P1000,");
  rig.pulse_input(4);
  EXPECT_TRUE(rig.run_until_output("^", 1s));
  EXPECT_EQ(rig.output(), "ES^") << "a pause ends too";
}

TEST(VxmWaits, StopCanBeHard) {
  Rig rig = Rig::online();
  rig.send("setI23,I1M100000,R");
  rig.run_for(3s);
  rig.press("Stop");
  EXPECT_TRUE(rig.run_until_output("^", 10ms));
  EXPECT_EQ(rig.output(), "ES^");
  EXPECT_NEAR(static_cast<double>(rig.position(1)), 5000, 30);
}

TEST(VxmWaits, StopCanBeDisabled) {
  Rig rig = Rig::online();
  rig.send("setI5,I1M10000,R");
  rig.run_for(1s);
  rig.click("Stop");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.output(), "^");
  EXPECT_EQ(rig.position(1), 10000);
}

TEST(VxmWaits, ProgramFourAfterStop) {
  Rig rig = Rig::online();
  rig.send("setI39,PM4,I2M9,PM0,I1M100000,R");
  rig.run_for(3s);
  rig.click("Stop");
  rig.run_for(10s);
  EXPECT_EQ(rig.output().substr(0, 2), "ES");
  EXPECT_EQ(rig.position(2), 9) << "App. C, bit 5";
  EXPECT_EQ(rig.ask("PM,"), "0\r");
}

TEST(VxmWaits, WithStopHeldNoProgramRuns) {
  Rig rig = Rig::online();
  rig.send("I1M4,");
  rig.press("Stop");
  rig.run_for(1s);
  rig.send("R");
  rig.run_for(5s);
  EXPECT_EQ(rig.position(1), 0) << "App. K";
  rig.release("Stop");
  rig.run_for(1s);
  rig.output();
  rig.send("K");
  rig.output();
  rig.run_program();
  EXPECT_EQ(rig.position(1), 4);
}

TEST(VxmWaits, InputFourCapturesPositions) {
  Rig rig = Rig::online();
  rig.send("setI133,I1M1000,P5,I1M1000,P5,R");
  rig.run_for(index_time(1000) + 200ms);
  rig.pulse_input(4);
  rig.run_for(index_time(1000) + 500ms);
  rig.press("Stop");
  EXPECT_TRUE(rig.run_until_output("^", 5s)) << "it does not stop the program";
  EXPECT_EQ(rig.output(), "^");
  EXPECT_EQ(visible(rig.ask("x")), "+0001000<cr>+0002000<cr>+0000000<cr>+0000000<cr>");
}

TEST(VxmWaits, ACaptureWhileMovingHasTheTrueStep) {
  Rig rig = Rig::online();
  rig.send("I1M10000,R");
  for (const auto pause : {1000ms, 1000ms, 1000ms, 1000ms, 500ms}) {
    rig.run_for(pause);
    rig.send("!");
  }
  EXPECT_TRUE(rig.run_until_output("^"));
  rig.output();
  const std::string four = rig.ask("x");
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(std::atof(four.substr(static_cast<std::size_t>(9 * i), 8).c_str()), 1000 + 2000 * i, 1);
}

TEST(VxmWaits, JoggingDuringAWaitSlewsAndStops) {
  Rig rig = waiting("", "U2,U0,");
  rig.press("1+");
  rig.run_for(300ms + 1s + 1s);
  rig.release("1+");
  rig.run_for(2s);
  EXPECT_NEAR(static_cast<double>(rig.position(1)), 1 + 1000 + 2000 + 1000, 3);
  EXPECT_TRUE(is_busy(rig));
  rig.input(1, true);
  EXPECT_TRUE(rig.run_until_output("^", 1s));
}

TEST(VxmWaits, JoggingOnlyInTheWaitsListed) {
  for (const char* wait : {"U0,", "U1,", "U30,", "U31,", "U50,", "U51,", "U90,"}) {
    Rig rig = waiting("", std::string("U2,") + wait);
    rig.click("2+");
    EXPECT_EQ(rig.position(2), 1) << wait;
  }
  for (const char* wait : {"P100,", "U6,", "U32,", "U33,"}) {
    Rig rig = waiting("", std::string("U2,") + wait);
    rig.click("2+");
    EXPECT_EQ(rig.position(2), 0) << wait << " (V74)";
  }
}

TEST(VxmWaits, SkipsLeaveOutOneListedCommand) {
  Rig rig = Rig::online_with_slave();
  rig.run("U11,(I3M8,I1M4,)I1M100,");
  EXPECT_EQ(rig.position(1), 100) << "a pair as one (V80)";
  EXPECT_EQ(rig.position(3), 0);
  rig.run("I2M1,U11,LA5,");
  EXPECT_EQ(rig.position(2), 1) << "a loop command";
  EXPECT_TRUE(same_time(rig.run("U11,"), 0s)) << "at the end nothing";
  rig.run("U12,U12,I2M10,");
  EXPECT_EQ(rig.position(2), 11) << "a skip";
}

TEST(VxmWaits, HoldStopsBeforeEachCommandAndShowsIt) {
  Rig rig = Rig::online();
  rig.send("PM1,I2M1,PM0,S1M-12,I1M3,JM1,P1,L2,U5,H");
  std::string shown = visible(rig.ask("R"));
  for (int i = 0; i < 20 && shown.find('^') == std::string::npos; ++i) {
    rig.send("G");
    rig.run_for(1s);
    shown += visible(rig.output());
  }
  EXPECT_EQ(
      shown,
      ":S1M2000<cr>:I1M3<cr>:JM1<cr>:I2M1<cr>:P1<cr>:L2<cr>:S1M2000<cr>:I1M3<cr>:JM1<cr>:I2M1<cr>:L2<cr>"
      ":U5<cr>^");
}

TEST(VxmWaits, HoldLetsPositionsAndStatusBeAsked) {
  Rig rig = Rig::online_with_slave();
  rig.send("I1M3,I3M4,P1,H");
  rig.ask("R");
  rig.send("G");
  rig.run_for(1s);
  rig.send("G");
  rig.run_for(1s);
  EXPECT_EQ(visible(rig.output()), ":I3M4<cr>:P1<cr>");
  EXPECT_EQ(rig.ask("XYZTV"), "+0000003\r+0000000\r+0000004\r+0000000\rB") << "p.32";
  EXPECT_EQ(rig.ask("K"), "^");
}

}  // namespace hw::vxm::proof
