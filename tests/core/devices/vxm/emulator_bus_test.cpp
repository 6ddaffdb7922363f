// Two controllers, start-up program, quirks (p.10, 30; App. C, G, O).
#include <cmath>

#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {

TEST(VxmBus, FourMotorsOneAfterAnother) {
  Rig rig = Rig::online_with_slave();
  EXPECT_TRUE(same_time(rig.run("I1M100,I2M200,I3M300,I4M400,"),
                        index_time(100) + index_time(200) + index_time(300) + index_time(400)));
  EXPECT_EQ(rig.ask("XYZT"), "+0000100\r+0000200\r+0000300\r+0000400\r");
  for (int m = 1; m <= 4; ++m) EXPECT_EQ(rig.load(m), 100 * m);
}

TEST(VxmBus, TheSlavesMotorsHaveTheirOwnSpeeds) {
  Rig rig = Rig::online_with_slave();
  EXPECT_TRUE(
      same_time(rig.run("S3M500,A4M5,I3M400,I4M400,"), index_time(400, 500) + index_time(400, 2000, 5)));
  EXPECT_TRUE(same_time(rig.run("IA3M0,"), index_time(400, 500)));
}

TEST(VxmBus, APairLastsAsLongAsItsLongerHalf) {
  Rig rig = Rig::online_with_slave();
  EXPECT_TRUE(same_time(rig.run("(I3M800,I1M4000,)I2M10,"), index_time(4000) + index_time(10)));
  EXPECT_TRUE(same_time(rig.run("(I4M-9000,I2M400,)"), index_time(9000)));
  EXPECT_EQ(rig.position(4), -9000);
  EXPECT_EQ(rig.position(2), 410);
}

TEST(VxmBus, StopsReachBothHalves) {
  Rig rig = Rig::online_with_slave();
  rig.send("(I3M100000,I1M100000,)R");
  rig.run_for(3s);
  EXPECT_EQ(rig.ask("K"), "^");
  EXPECT_NEAR(static_cast<double>(rig.load(1)), 5000, 1);
  EXPECT_NEAR(static_cast<double>(rig.load(3)), 5000, 1);
  rig.run_for(5s);
  EXPECT_NEAR(static_cast<double>(rig.load(3)), 5000, 1);
  EXPECT_EQ(rig.position(3), rig.load(3));
}

TEST(VxmBus, DecelerateReachesTheSlave) {
  Rig rig = Rig::online_with_slave();
  rig.send("I3M100000,I1M7,R");
  rig.run_for(3s);
  rig.send("D");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_NEAR(static_cast<double>(rig.position(3)), 6000, 1);
  EXPECT_EQ(rig.position(1), 7);
}

TEST(VxmBus, LimitsOfTheSlave) {
  Rig rig = Rig::online_with_slave();
  AxisPlace travel;
  travel.plus = Steps(1000);
  rig.place(3, travel);
  rig.send("O3,I3M5000,I1M7,R");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.output(), "O^");
  EXPECT_EQ(rig.position(3), 1000);
  EXPECT_EQ(rig.position(1), 0);
  rig.run("I3M-100,I3M0,");
  EXPECT_EQ(rig.position(3), 1000);
}

TEST(VxmBus, CoupledProgramsStartTogetherAndThePromptWaitsForBoth) {
  Rig rig = Rig::online_with_slave();
  rig.send("[PM-1,I1M9000,]PM-1,I1M100,PMA1,");
  EXPECT_TRUE(same_time(rig.run_program(), index_time(9000), 5s)) << "or ends with the Master's own";
  rig.run_for(10s);
  EXPECT_EQ(rig.position(3), 9000);
  EXPECT_EQ(rig.position(1), 100);
}

TEST(VxmBus, AMotorThreeCommandErasesTheSlavesProgramZero) {
  Rig rig = Rig::online_with_slave();
  rig.send("[PM-0,I1M50,]");
  rig.run("I3M5,");
  EXPECT_EQ(rig.position(3), 5);
  rig.send("CPMA0,");
  rig.run("I1M1,");
  EXPECT_EQ(rig.position(3), 5) << "the caution of p.48";
}

TEST(VxmBus, WithoutASlaveTheMasterIsQuietUntilItNeedsIt) {
  Rig rig = Rig::online();
  rig.send("setDM65,");
  EXPECT_EQ(rig.output(), "");
  EXPECT_EQ(rig.ask("getDM"), "65\r");
  EXPECT_EQ(rig.ask("getD2"), "2\r");
  rig.run("I1M3,");
  EXPECT_EQ(rig.ask("Z"), "EB");
  rig.run_for(10s);
  EXPECT_EQ(rig.output(), "");
  EXPECT_EQ(rig.ask("V"), "J");
}

TEST(VxmBus, NullZeroesAllFour) {
  Rig rig = Rig::online_with_slave();
  rig.run("I1M1,I2M2,I3M3,I4M4,");
  rig.send("N");
  EXPECT_EQ(rig.ask("XYZT"), "+0000000\r+0000000\r+0000000\r+0000000\r");
}

TEST(VxmBus, SettingsOfMotorsThreeAndFourAreSaved) {
  Rig rig = Rig::online_with_slave();
  rig.send("setM3M5,setj4M321,setL3M-1,rsm");
  EXPECT_TRUE(rig.run_until_output("^"));
  rig.power_cycle();
  rig.send("F");
  rig.output();
  EXPECT_EQ(rig.ask("getM3M"), "5\r");
  EXPECT_EQ(rig.ask("getj4M"), "321\r");
  EXPECT_EQ(rig.ask("getL3M"), "-1\r");
}

TEST(VxmStartup, ProgramFourComesFirstOnTheFirstRunOnly) {
  Rig rig = Rig::online();
  rig.send("PM4,I2M5,PM0,I1M7,setDM129,rsm");
  EXPECT_TRUE(rig.run_until_output("^"));
  rig.power_cycle();
  rig.output();
  rig.click("Run");
  EXPECT_TRUE(rig.run_until_output("^", 10s));
  rig.run_for(10s);
  EXPECT_EQ(rig.load(2), 5) << "App. O, bit 7";
  EXPECT_EQ(rig.load(1), 7) << "and then the program itself";
  EXPECT_EQ(rig.output(), "^");
  rig.click("Run");
  rig.run_for(10s);
  EXPECT_EQ(rig.load(2), 5);
  EXPECT_EQ(rig.load(1), 14);
}

TEST(VxmQuirks, OverrunBlocksUntilThePowerIsSwitched) {
  Rig plain = Rig::online();
  EXPECT_EQ(plain.ask("XX"), "+0000000\r+0000000\r") << "not by default (V14)";
  Rig rig(DeviceOptions{{"quirk", "overrun"}});
  rig.send("F");
  rig.run_for(1s);
  rig.send("V");
  rig.run_for(1s);
  EXPECT_EQ(rig.output(), "R");
  rig.send("X");
  rig.send("V");
  rig.run_for(1s);
  rig.output();
  EXPECT_EQ(rig.ask("V"), "") << "blocked";
  rig.run_for(1h);
  EXPECT_EQ(rig.ask("K"), "");
  EXPECT_EQ(rig.ask("res"), "");
  bool lit = false, dark = false;
  for (int i = 0; i < 300; ++i, rig.run_for(10ms)) (rig.online_lamp() ? lit : dark) = true;
  EXPECT_TRUE(lit && dark) << "the On-Line lamp flashes (p.30)";
  rig.power_cycle();
  rig.send("V");
  rig.run_for(1s);
  EXPECT_EQ(rig.output(), "J");
}

TEST(VxmQuirks, BarredErrors) {
  Rig rig(DeviceOptions{{"quirk", "e-bar"}});
  rig.send("F");
  rig.send("U7,I1M100,R");
  EXPECT_TRUE(
      rig.run_until_output("\xC5"
                           "C"))
      << "V01";
  rig.send("K");
  rig.output();
  EXPECT_EQ(rig.ask("setD0,"), "\xC5N");
}

// What is not in the list of V13 is dropped; other firmware takes a mode at once (V103).
TEST(VxmQuirks, AModeIsTakenWhileAProgramRuns) {
  const auto run_and_send_e = [](Rig& rig) {
    rig.send("F");
    rig.send("PM-0,I1M4000,R");
    rig.run_for(100ms);
    rig.output();
    return rig.ask("EV");
  };
  Rig plain;
  EXPECT_EQ(run_and_send_e(plain), "B") << "E is dropped by default";
  Rig rig(DeviceOptions{{"quirk", "mode-while-running"}});
  EXPECT_EQ(run_and_send_e(rig), "EVB") << "both are echoed";
  rig.send("F");
  EXPECT_EQ(rig.ask("V"), "B") << "the program runs on, without echo";
  EXPECT_TRUE(rig.run_until_output("^"));
}

// App. A p.32 and 33, App. D p.43: the versions from which these are known.
TEST(VxmQuirks, AnOldFirmwareKnowsNeitherOutputsNorPulses) {
  Rig rig(DeviceOptions{{"quirk", "old-firmware"}});
  rig.send("F");
  EXPECT_EQ(rig.ask("getD0"), "1.19\r");
  EXPECT_EQ(rig.ask("$"), "");
  EXPECT_EQ(rig.ask("getPA"), "");
  EXPECT_EQ(rig.ask("V"), "R") << "nothing has come of that";
  rig.send("HPM-0,I1M400,R");
  rig.run_for(100ms);
  EXPECT_EQ(rig.output(), ":\r") << "it holds, and does not tell before what";
}

TEST(VxmErrors, AfterEachErrorTheControllerIsWellAgain) {
  for (const char* bad : {"U7,I1M100,", "I1M1,LA2,LA2,LA2,LA2,LA2,LA2,LA2,LA2,LA2,LA2,LA2,", "JM0,"}) {
    Rig rig = Rig::online();
    rig.send("U5,");
    rig.send(bad);
    rig.send("R");
    EXPECT_TRUE(rig.run_until_output("E")) << bad;
    rig.run_for(1s);
    rig.output();
    EXPECT_EQ(rig.ask("I1M1,PM3,V"), "") << bad;
    rig.click("Run");
    EXPECT_EQ(rig.output(), "") << bad;
    EXPECT_EQ(rig.ask("K"), "^") << bad;
    EXPECT_EQ(rig.ask("$"), std::string(1, '\0')) << bad;
    EXPECT_EQ(rig.ask("PM,"), "0\r") << bad;
    EXPECT_TRUE(same_time(rig.run("IA1M-0,I1M400,"), index_time(400))) << bad;
  }
}

TEST(VxmErrors, TheBusErrorResets) {
  Rig rig = Rig::online();
  rig.send("U5,I1M5,I3M400,R");
  EXPECT_TRUE(rig.run_until_output("EB"));
  EXPECT_EQ(rig.output(), "EB") << "no prompt";
  EXPECT_FALSE(rig.out(1));
  EXPECT_EQ(rig.ask("V"), "J");
  rig.send("F");
  EXPECT_EQ(rig.ask("M"), "256\r") << "as power off and on: unsaved programs are gone";
  EXPECT_EQ(rig.ask("X"), "+0000000\r");
}

// ---- each controller has a power switch and a circuit breaker of its own

constexpr int master = 0, slave = 1;
bool slave_power_lamp(const Rig& rig) { return (rig.view().lamps >> 2) & 1u; }

TEST(VxmSupply, ASlaveThatIsSwitchedOffIsMissedWhenItIsNeeded) {
  Rig rig = Rig::online_with_slave();
  rig.operate(bench::Power(false, slave));
  EXPECT_FALSE(slave_power_lamp(rig));
  EXPECT_TRUE(rig.power_lamp());
  EXPECT_EQ(rig.view().switches_on & 3u, 1u);
  EXPECT_EQ(rig.ask("getD2,"), "2\r");
  rig.send("I1M100,R");
  EXPECT_TRUE(rig.run_until_output("^")) << "motor 1 needs no Slave";
  rig.output();
  rig.send("CI3M400,R");
  EXPECT_TRUE(rig.run_until_output("EB"));
  EXPECT_EQ(rig.load(3), 0);
}

TEST(VxmSupply, ASlaveThatLosesItsPowerInAMoveStopsThereAndTheMasterResets) {
  Rig rig = Rig::online_with_slave();
  rig.send("I3M100000,R");
  rig.run_for(3s);
  rig.operate(bench::Power(false, slave));
  EXPECT_EQ(rig.output(), "EB");
  const auto there = rig.load(3);
  EXPECT_GT(there, 1000);
  rig.run_for(10s);
  EXPECT_EQ(rig.load(3), there);
  EXPECT_EQ(rig.ask("V"), "J") << "in local mode, as after power-up";
}

TEST(VxmSupply, SwitchedOnAgainTheSlaveServesWithoutFlashing) {
  Rig rig = Rig::online_with_slave();
  rig.operate(bench::Power(false, slave));
  rig.run_for(1s);
  rig.operate(bench::Power(true, slave));
  rig.run_for(1100ms);
  for (int i = 0; i < 50; ++i, rig.run_for(100ms)) EXPECT_TRUE(slave_power_lamp(rig)) << "p.10";
  rig.run("I3M400,");
  EXPECT_EQ(rig.position(3), 400);
}

TEST(VxmSupply, ASlaveWhoseMasterIsOffStillJogs) {
  Rig rig = Rig::online_with_slave();
  rig.operate(bench::Power(false, master));
  EXPECT_FALSE(rig.power_lamp());
  EXPECT_TRUE(slave_power_lamp(rig));
  EXPECT_EQ(rig.ask("V"), "");
  rig.click("3+");
  EXPECT_EQ(rig.load(3), 1);
  rig.click("1+");
  EXPECT_EQ(rig.load(1), 0);
}

TEST(VxmSupply, ABreakerTakesThePowerUntilAHandPushesItIn) {
  Rig rig = Rig::online();
  rig.send("I1M100000,R");
  rig.run_for(3s);
  rig.operate(bench::Breaker(master, true));
  EXPECT_FALSE(rig.power_lamp());
  EXPECT_EQ(rig.view().breakers_out, 1u) << "its white centre stands out (p.30)";
  const auto there = rig.load(1);
  rig.operate(bench::Power(false));
  rig.operate(bench::Power(true));
  rig.run_for(10s);
  EXPECT_FALSE(rig.power_lamp()) << "the switch does not help";
  EXPECT_EQ(rig.load(1), there);
  rig.operate(bench::Breaker(master, false));
  EXPECT_EQ(rig.view().breakers_out, 0u);
  EXPECT_TRUE(rig.power_lamp());
  EXPECT_TRUE(rig.online_lamp()) << "both for a second, as after switching on";
  rig.run_for(10s);
  EXPECT_EQ(rig.ask("FX"), "+0000000\r");
}

TEST(VxmSupply, OperatingAMissingSlaveIsRefused) {
  Rig rig;
  EXPECT_FALSE(rig.emulator().operate(bench::Power(false, slave)));
  EXPECT_FALSE(rig.emulator().operate(bench::Breaker(slave, true)));
  EXPECT_TRUE(rig.power_lamp());
}

TEST(VxmBus, APairReportsASwitchWhenItIsMet) {
  Rig rig = Rig::online_with_slave();
  AxisPlace travel;
  travel.plus = Steps(500);
  rig.place(1, travel);
  const Duration began = rig.elapsed();
  rig.send("O1,(I3M1000,I1M1000,)I2M5,R");
  EXPECT_TRUE(rig.run_until_output("O"));
  // Ramps of 2000 steps/s2: 500 steps take sqrt(2*500/2000) s, 1000 with their way down 2*sqrt(1000/2000) s.
  EXPECT_TRUE(same_time(rig.elapsed() - began, from_seconds(std::sqrt(0.5))));
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.output(), "O^") << "told once";
  EXPECT_TRUE(same_time(rig.elapsed() - began, index_time(1000) + index_time(5)));
  EXPECT_EQ(rig.position(1), 500);
  EXPECT_EQ(rig.position(3), 1000);

  rig.send("PM-0,O3,(I3M1000,I1M1000,)I2M5,R");
  const Duration again = rig.elapsed();
  EXPECT_TRUE(rig.run_until_output("O"));
  EXPECT_TRUE(same_time(rig.elapsed(), again)) << "it stands on its switch";
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_TRUE(same_time(rig.elapsed() - again, index_time(1000))) << "the other half ends first";
  EXPECT_EQ(rig.position(2), 5) << "and the program with it";
}

TEST(VxmBus, TheLatestSlowingOfFourMotorsIsReported) {
  Rig rig = Rig::online_with_slave();
  rig.run("I3M4000,");
  EXPECT_EQ(rig.ask("*"), "+0003000\r") << "1000 steps before its end";
  rig.run("I1M-3000,");
  EXPECT_EQ(rig.ask("*"), "-0002000\r") << "a motor of the Master is younger now";
  rig.run("(I4M4000,I2M2000,)");
  EXPECT_EQ(rig.ask("*"), "+0003000\r") << "motor 4 slows after motor 2";
}

}  // namespace hw::vxm::proof
