// Motion: ramps, stops, limits, backlash (p.16 to 18, 23; App. E, F, N, O). The profile is a trapezoid with
// 1000*A steps/s2 from standstill (V54 to V56).
#include <cmath>

#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {
namespace {

AxisPlace between(std::int64_t minus, std::int64_t plus) {
  AxisPlace p;
  p.minus = Steps(minus);
  p.plus = Steps(plus);
  return p;
}

AxisPlace home_zone(std::int64_t from, std::int64_t to) {
  AxisPlace p;
  p.home_from = Steps(from);
  p.home_to = Steps(to);
  return p;
}

}  // namespace

TEST(VxmMotion, AShortIndexIsATriangle) {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("I1M400,"), from_seconds(2 * std::sqrt(400.0 / 2000)), 0us + 1ns));
  EXPECT_EQ(rig.position(1), 400);
}

TEST(VxmMotion, ALongIndexIsATrapezoid) {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("I1M10000,"), 6s, 1ns)) << "1 s up, 4 s at 2000 steps/s, 1 s down";
  EXPECT_TRUE(same_time(rig.run("S1M6000,A1M127,I1M60000,"), index_time(60000, 6000, 127), 1us));
}

TEST(VxmMotion, TheSlowestAndTheFastest) {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("S1M1,A1M1,I1M3,"), index_time(3, 1, 1)));
  EXPECT_TRUE(same_time(rig.run("I1M1,"), index_time(1, 1, 1)));
  EXPECT_TRUE(same_time(rig.run("S1M6000,A1M127,I1M1,"), index_time(1, 6000, 127)));
  EXPECT_EQ(rig.position(1), 5);
}

TEST(VxmMotion, ThePositionFollowsTheRamp) {
  Rig rig = Rig::online();
  const Duration start = rig.elapsed();
  rig.send("I1M10000,R");
  for (const auto& [at, steps] :
       {std::pair{500, 250}, {1000, 1000}, {3000, 5000}, {5000, 9000}, {5500, 9750}}) {
    rig.run_for(Duration(std::chrono::milliseconds(at)) - (rig.elapsed() - start));
    EXPECT_NEAR(static_cast<double>(rig.position(1)), steps, 1) << at << " ms";
    EXPECT_EQ(rig.load(1), rig.position(1));
  }
}

TEST(VxmMotion, IndexesFollowOneAnother) {
  Rig rig = Rig::online();
  EXPECT_TRUE(
      same_time(rig.run("I1M400,I2M-900,I1M-100,"), index_time(400) + index_time(900) + index_time(100)));
  rig.send("R");
  rig.run_for(index_time(400) - 1ms);
  EXPECT_EQ(rig.position(2), -900) << "motor 2 still stands (V59)";
}

TEST(VxmMotion, StepsAtAChangeOfSpeedWithinAProgramCountFromTheNextIndex) {
  Rig rig = Rig::online();
  EXPECT_TRUE(
      same_time(rig.run("I1M4000,S1M500,A1M10,I1M4000,"), index_time(4000) + index_time(4000, 500, 10)));
}

TEST(VxmMotion, TheRegisterWrapsAt24Bits) {
  Rig rig = Rig::online();
  rig.run("I1M8388607,", 48h);
  EXPECT_EQ(rig.ask("X"), "+8388607\r");
  rig.run("I1M1,");
  EXPECT_EQ(rig.ask("X"), "-8388608\r") << "V21";
  rig.run("I1M-1,");
  EXPECT_EQ(rig.ask("X"), "+8388607\r");
}

TEST(VxmMotion, DecelerateEndsTheIndexOnly) {
  Rig rig = Rig::online();
  const Duration start = rig.elapsed();
  rig.send("I1M100000,I1M50,R");
  rig.run_for(3s);
  rig.send("D");
  rig.run_for(999ms);
  EXPECT_EQ(rig.ask("V"), "B");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_NEAR(static_cast<double>(rig.position(1)), 6050, 1) << "1000 steps of ramp, then the next command";
  EXPECT_TRUE(same_time(rig.elapsed() - start, 4s + index_time(50), 2ms));
}

TEST(VxmMotion, DecelerateDuringTheRampUp) {
  Rig rig = Rig::online();
  const Duration start = rig.elapsed();
  rig.send("I1M100000,R");
  rig.run_for(500ms);  // 250 steps, 1000 steps/s
  rig.send("D");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_NEAR(static_cast<double>(rig.position(1)), 500, 1);
  EXPECT_TRUE(same_time(rig.elapsed() - start, 1s, 2ms));
  rig.output();
  EXPECT_NEAR(std::atof(rig.ask("*").c_str()), 250, 1);
}

TEST(VxmMotion, DecelerateDuringTheRampDownChangesNothing) {
  Rig rig = Rig::online();
  const Duration start = rig.elapsed();
  rig.send("I1M10000,R");
  rig.run_for(5500ms);
  rig.send("DD");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.position(1), 10000);
  EXPECT_TRUE(same_time(rig.elapsed() - start, 6s));
}

TEST(VxmMotion, TheRampDownBeganHere) {
  Rig rig = Rig::online();
  rig.send("I1M100000,R");
  rig.run_for(3s);
  rig.send("D");
  EXPECT_TRUE(rig.run_until_output("^"));
  rig.output();
  EXPECT_NEAR(std::atof(rig.ask("*").c_str()), 5000, 1);
}

TEST(VxmMotion, KillStopsWithinOneStep) {
  Rig rig = Rig::online();
  rig.send("I1M100000,I2M9,R");
  rig.run_for(3s);
  EXPECT_EQ(rig.ask("K"), "^");
  const auto stands = rig.position(1);
  EXPECT_NEAR(static_cast<double>(stands), 5000, 1);
  rig.run_for(1min);
  EXPECT_EQ(rig.position(1), stands);
  EXPECT_EQ(rig.load(1), stands) << "the counter keeps the true count (V61)";
  EXPECT_EQ(rig.position(2), 0);
  EXPECT_TRUE(same_time(rig.run("IA1M0,"), index_time(stands)));
}

TEST(VxmMotion, ALimitStopsAtOnce) {
  Rig rig = Rig::online();
  rig.place(1, between(-100, 1000));
  EXPECT_TRUE(same_time(rig.run("I1M5000,"), 1s));
  EXPECT_EQ(rig.position(1), 1000);
  EXPECT_TRUE(same_time(rig.run("I1M50,"), 0s)) << "further in does not start (V62)";
  EXPECT_EQ(rig.position(1), 1000);
  rig.run("I1M-50,");
  EXPECT_EQ(rig.position(1), 950) << "out of it does";
  rig.run("I1M-5000,");
  EXPECT_EQ(rig.position(1), -100);
}

TEST(VxmMotion, ASwitchOperatedByHandStopsToo) {
  Rig rig = Rig::online();
  rig.send("O1,I1M100000,R");
  rig.run_for(3s);
  rig.limit(1, '-', true);
  rig.run_for(1s);
  EXPECT_EQ(rig.ask("V"), "B") << "the other end's";
  rig.limit(1, '+', true);
  EXPECT_TRUE(rig.run_until_output("^", 1ms));
  EXPECT_EQ(rig.output(), "O^");
  EXPECT_NEAR(static_cast<double>(rig.position(1)), 7000, 1);
}

TEST(VxmMotion, ModeODecidesWhetherALimitEndsTheProgram) {
  struct Mode {
    const char* set;
    const char* output;
    std::int64_t second_motor;
  };
  for (const Mode& m :
       {Mode{"O0,", "^", 7}, Mode{"O1,", "O^", 7}, Mode{"O2,", "^", 0}, Mode{"O3,", "O^", 0}}) {
    Rig rig = Rig::online();
    rig.place(1, between(-1000, 1000));
    rig.send(m.set);
    rig.send("I1M5000,I2M7,R");
    EXPECT_TRUE(rig.run_until_output("^"));
    rig.run_for(10s);
    EXPECT_EQ(rig.output(), m.output) << m.set;
    EXPECT_EQ(rig.position(2), m.second_motor) << m.set;
    rig.send("CI1M-0,I2M1,R");
    EXPECT_TRUE(rig.run_until_output("^"));
    EXPECT_EQ(rig.output(), m.output) << m.set << " home";
    EXPECT_EQ(rig.position(2), m.second_motor + 1) << "homing never ends the program (p.46)";
  }
}

TEST(VxmMotion, LimitSwitchModes) {
  // Normally open to run: the operated switch closes.
  Rig open = Rig::online();
  open.send("setL1M-1,");
  open.place(1, between(-1000, 1000));
  open.run("I1M5000,");
  EXPECT_EQ(open.position(1), 1000);
  // For homing only.
  for (const char* mode : {"setL1M2,", "setL1M-2,"}) {
    Rig rig = Rig::online();
    rig.send(mode);
    rig.place(1, between(-1000, 1000));
    rig.run("I1M5000,");
    EXPECT_EQ(rig.position(1), 5000) << mode;
    rig.run("I1M-5500,I1M0,");
    EXPECT_EQ(rig.position(1), 1000) << mode << ": enabled for the duration of the command (p.17)";
  }
  // Each motor has its own mode.
  Rig rig = Rig::online();
  rig.send("setL1M2,");
  rig.place(2, between(-1000, 1000));
  rig.run("I2M5000,");
  EXPECT_EQ(rig.position(2), 1000);
}

TEST(VxmMotion, HomeSwitchOfARotaryTable) {
  // Appendix N, p.67: the printed program, from outside, from the far side and from inside the switch.
  for (const std::int64_t start : {0, -5000, -2500}) {
    Rig rig = Rig::online();
    rig.send("setL1M-2,");
    rig.place(1, home_zone(-3000, -2000));
    if (start != 0) rig.run("I1M" + std::to_string(start) + ",");
    if (start == -5000) rig.run("I1M5000,");
    rig.run("S1M600,I1M-0,I1M4000,I1M-0,IA1M-0,");
    EXPECT_EQ(rig.position(1), 0);
    EXPECT_EQ(rig.load(1), -2000) << "the same edge from " << start;
  }
}

TEST(VxmMotion, BacklashEndsEveryIndexGoingPositive) {
  Rig rig = Rig::online();
  rig.place(1, between(-2000, 100'000));
  rig.send("B30,");
  EXPECT_TRUE(same_time(rig.run("I1M-100,"), index_time(130) + index_time(30)));
  EXPECT_EQ(rig.position(1), -100);
  EXPECT_TRUE(same_time(rig.run("I1M100,"), index_time(100))) << "positive indexes as they are";
  EXPECT_TRUE(same_time(rig.run("IA1M-50,"), index_time(80) + index_time(30))) << "absolute ones too (V64)";
  EXPECT_EQ(rig.position(1), -50);
  EXPECT_TRUE(same_time(rig.run("I2M-100,"), index_time(130) + index_time(30)))
      << "one setting for all motors";
  rig.run("I1M-0,");
  EXPECT_EQ(rig.position(1), -2000) << "not at the end of a home move (App. F)";
  rig.run("I1M2000,");
  rig.send("CI1M-100,R");
  rig.run_for(index_time(130));
  EXPECT_NEAR(static_cast<double>(rig.position(1)), -130, 1) << "X shows the true motion";
}

TEST(VxmMotion, DirectionsCanBeInverted) {
  Rig rig = Rig::online();
  rig.place(1, between(-1000, 2000));
  rig.send("setDM3,");
  rig.run("I1M400,");
  EXPECT_EQ(rig.position(1), 400);
  EXPECT_EQ(rig.load(1), -400);
}

TEST(VxmMotion, AJammedMotorCountsAndStands) {
  Rig rig = Rig::online();
  rig.operate(bench::Jam(AxisId{0}, true));
  rig.run("I1M400,");
  EXPECT_EQ(rig.position(1), 400) << "open loop: it cannot know";
  EXPECT_EQ(rig.load(1), 0);
  rig.operate(bench::Jam(AxisId{0}, false));
  rig.operate(bench::Slip(AxisId{0}, Steps(-25)));
  EXPECT_EQ(rig.load(1), -25);
  rig.run("I1M400,");
  EXPECT_EQ(rig.load(1), 375);
}

TEST(VxmMotion, ZeroLengthAbsoluteIndex) {
  Rig rig = Rig::online();
  rig.send("O1,");
  EXPECT_TRUE(same_time(rig.run("IA2M0,"), 0s));
  EXPECT_EQ(rig.ask("#"), "2\r") << "counts for # (V66)";
}

TEST(VxmMotion, SpeedFromTheAnalogInputIsReadWhenItIsExecuted) {
  Rig rig = Rig::online();
  rig.send("S1M-1,I1M100,L0,R");
  rig.run_for(1min);
  rig.send("K");
  rig.output();
  rig.analog(1, 0);
  EXPECT_TRUE(same_time(rig.run("S1M-51,I1M20000,"), index_time(20000, 5000)));
  rig.analog(1, 1023);
  EXPECT_TRUE(same_time(rig.run_program(), index_time(20000, 5999))) << "5000 + 1000*1023/1024, rounded down";
}

TEST(VxmMotion, MotorsOneAndTwoStandWhereTheOthersAreRun) {
  Rig lone = Rig::online();
  EXPECT_EQ(lone.ask("I3M400,"), "");
  EXPECT_EQ(lone.used_bytes(), 4) << "stored without a complaint";
  lone.send("R");
  lone.run_for(1s);
  EXPECT_EQ(lone.output(), "EB");
}

}  // namespace hw::vxm::proof
