// Continuous indexes and pulses tied to positions (App. D, G; V35, V75 to V78, V82).
#include <cmath>

#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {
namespace {

using Places = std::vector<std::int64_t>;

void expect_ec(const std::string& program) {
  Rig rig = Rig::online();
  rig.send(program + "R");
  EXPECT_TRUE(rig.run_until_output("EC", 1min)) << program;
  rig.run_for(1min);
  EXPECT_EQ(rig.output(), "EC") << program;
  EXPECT_EQ(rig.ask("V"), "") << "held until K";
  const auto stands = rig.load(1);
  rig.run_for(10s);
  EXPECT_EQ(rig.load(1), stands);
  EXPECT_EQ(rig.ask("K"), "^");
  EXPECT_EQ(rig.ask("V"), "R");
}

double speed_after(double from, double steps, double rate) {
  return std::sqrt(from * from + 2 * rate * steps);
}

}  // namespace

TEST(VxmNonstop, PulsesComeAtTheExactStepAndTime) {
  Rig rig = Rig::online();
  const Duration start = rig.elapsed();
  rig.run("S1M2000,U7,I1M1000,I1M400,I1M600,U9,");
  ASSERT_EQ(rig.pulse_positions(1), (Places{1000, 1400, 2000}));
  const auto& p = rig.pulses();
  EXPECT_TRUE(same_time(p[0].at.time_since_epoch() - start, 1s, 1us));
  EXPECT_TRUE(same_time(p[1].at.time_since_epoch() - start, 1200ms, 1us));
  EXPECT_TRUE(same_time(p[2].at.time_since_epoch() - start, 1500ms, 1us));
  EXPECT_EQ(rig.position(1), 3000);
}

TEST(VxmNonstop, OneHundredPulsesInALoop) {
  Rig rig = Rig::online();
  rig.run("U7,I2M400,LA100,U9,");
  const Places at = rig.pulse_positions(2);
  ASSERT_EQ(at.size(), 100u) << "U7 met again has no effect (V75)";
  for (std::size_t i = 0; i < at.size(); ++i) EXPECT_EQ(at[i], 400 * (static_cast<std::int64_t>(i) + 1));
  EXPECT_EQ(rig.position(2), 41000);
}

TEST(VxmNonstop, SpeedChangesBetweenIndexes) {
  Rig rig = Rig::online();
  rig.run("S2M1500,U7,I2M2000,S2M3000,I2M4000,S2M500,I2M800,U9,");
  EXPECT_EQ(rig.pulse_positions(2), (Places{2000, 6000, 6800}));
  // 800 steps do not suffice to slow from 3000 to 500 steps/s at 2000 steps/s2.
  const double v = speed_after(3000, 800, -2000);
  EXPECT_NEAR(static_cast<double>(rig.position(2)), 6800 + v * v / 4000, 1) << "V76";
}

TEST(VxmNonstop, ThePaceOfASpeedChangeIsTheBlocksAcceleration) {
  Rig rig = Rig::online();
  // 500 steps/s after 62.5 steps and 0.25 s; 937.5 steps; up to 1000 steps/s over 187.5 steps in 0.25 s.
  EXPECT_TRUE(same_time(rig.run("S1M500,U77,I1M1000,S1M1000,I1M1000,U99,"),
                        from_seconds(0.25 + 937.5 / 500 + 0.25 + 812.5 / 1000), 5us));
}

TEST(VxmNonstop, OutputsLoopsAndJumpsAreAllowedInside) {
  Rig rig = Rig::online();
  rig.send("PM1,I1M100,PM0,");
  rig.run("U77,I1M500,U5,JM1,U4,U15,U14,U17,U19,LM0,I1M50,LA3,U9,");
  EXPECT_GT(rig.position(1), 750);
  EXPECT_EQ(rig.ask("$"), std::string(1, 12));
}

TEST(VxmNonstop, EachIndexSignalsTheHost) {
  Rig rig = Rig::online();
  rig.send("U8,I1M300,I1M300,I1M300,U99,R");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.output(), "@@@^");
  EXPECT_EQ(rig.position(1), 900);
}

TEST(VxmNonstop, ForbiddenCommandsRaiseEC) {
  expect_ec("U7,I1M100,");
  expect_ec("U77,I1M100,I2M100,U9,");
  expect_ec("U77,I1M100,P1,I1M100,U9,");
  expect_ec("U7,I1M100,U0,U9,");
  expect_ec("U7,I1M100,IA1M500,U9,");
  expect_ec("U7,I1M100,I1M0,U9,");
  expect_ec("U7,I1M100,U92,");
  expect_ec("U7,I1M100,U92,I2M100,");
  expect_ec("U7,I3M100,U9,");
}

TEST(VxmNonstop, TheGeneratedIndexServesTheNextRun) {
  Rig rig = Rig::online();
  const Duration first = rig.run("S1M1000,U7,I1M1000,U91,I2M3,");
  rig.forget_pulses();
  EXPECT_TRUE(same_time(rig.run_program(), first, 5us));
  EXPECT_EQ(rig.position(1), 2500);
  EXPECT_EQ(rig.pulse_positions(1), (Places{2250})) << "none for the stopping distance";
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M237<cr>S1M1000<cr>U7<cr>I1M1000<cr>U92<cr>I1M250<cr>I2M3<cr>");
}

TEST(VxmNonstop, NegativeBlocks) {
  Rig rig = Rig::online();
  rig.run("S1M1000,U7,I1M-1000,I1M-500,U91,");
  EXPECT_EQ(rig.pulse_positions(1), (Places{-1000, -1500}));
  EXPECT_EQ(rig.position(1), -1750);
  EXPECT_NE(rig.ask("lst").find("U92\rI1M-250\r"), std::string::npos);
}

TEST(VxmNonstop, DecelerateAndKillInsideABlock) {
  Rig rig = Rig::online();
  rig.send("S1M1000,U77,I1M100000,U9,R");
  rig.run_for(2500ms);  // 250 + 2000 steps
  EXPECT_EQ(rig.ask("K"), "^");
  EXPECT_NEAR(static_cast<double>(rig.position(1)), 2250, 1);
  EXPECT_EQ(rig.ask("R"), "");
  rig.run_for(1s);
  EXPECT_EQ(rig.ask("V"), "B");
}

TEST(VxmPulses, AFixedCombOfPositions) {
  struct Comb {
    const char* set;
    std::int64_t there, back;
    Places expected;
  };
  for (const Comb& c :
       {Comb{"setP1M4,", 12, -18, {2, 6, 10, 10, 6, 2, -2, -6}}, Comb{"setP1M2,", 5, -7, {1, 3, 5, 3, 1, -1}},
        Comb{"setP1M3,", 8, -12, {2, 5, 8, 5, 2, -1, -4}}, Comb{"setP1M5,", 9, -18, {3, 8, 8, 3, -2, -7}}}) {
    Rig rig = Rig::online();
    rig.send(c.set);
    rig.run("I1M" + std::to_string(c.there) + ",I1M" + std::to_string(c.back) + ",");
    EXPECT_EQ(rig.pulse_positions(1), c.expected) << c.set;
  }
}

TEST(VxmPulses, EveryStep) {
  Rig rig = Rig::online();
  rig.send("setP1M1,");
  rig.run("I1M4,I1M-6,");
  const Places at = rig.pulse_positions(1);
  ASSERT_GE(at.size(), 4u);
  EXPECT_EQ(Places(at.begin(), at.begin() + 4), (Places{1, 2, 3, 4}));
  EXPECT_EQ(at.size(), 10u);
}

TEST(VxmPulses, ThePhaseRestartsAtSetAndAtNull) {
  Rig rig = Rig::online();
  rig.run("I1M3,");
  rig.send("setP1M10,");
  rig.run("I1M20,");
  EXPECT_EQ(rig.pulse_positions(1), (Places{8, 18})) << "half a period from where it was set";
  rig.send("N");
  rig.forget_pulses();
  rig.run("I1M20,");
  EXPECT_EQ(rig.pulse_positions(1), (Places{5, 15}));
}

TEST(VxmPulses, JoggingMakesThemToo) {
  Rig rig = Rig::online();
  rig.send("setP2M2,Q");
  for (int i = 0; i < 5; ++i) rig.click("2+");
  EXPECT_EQ(rig.pulse_positions(2), (Places{1, 3, 5})) << "App. D note";
}

TEST(VxmPulses, MotorsThreeAndFourUseTheSlavesOutput) {
  Rig rig = Rig::online_with_slave();
  rig.send("setP3M4,");
  rig.run("I3M8,");
  EXPECT_EQ(rig.pulse_positions(3, 6), (Places{2, 6}));
  EXPECT_TRUE(rig.pulse_positions(3, 2).empty());
}

TEST(VxmPulses, TheirTimesAreThoseOfTheSteps) {
  Rig rig = Rig::online();
  rig.send("setP1M1000,");
  const Duration start = rig.elapsed();
  rig.run("I1M10000,");
  ASSERT_EQ(rig.pulses().size(), 10u);
  EXPECT_TRUE(same_time(rig.pulses()[0].at.time_since_epoch() - start, from_seconds(std::sqrt(0.5)), 1us));
  EXPECT_TRUE(same_time(rig.pulses()[5].at.time_since_epoch() - start, 3250ms, 1us)) << "at 5500";
}

TEST(VxmPulses, OutputTwoIsSeenHighForTheWidth) {
  Rig rig = Rig::online();
  rig.send("setP1M2,setPA200,I1M1,R");
  rig.run_until_output("^");
  EXPECT_TRUE(rig.out(2));
  rig.run_for(1999us);
  EXPECT_TRUE(rig.out(2));
  rig.run_for(2us);
  EXPECT_FALSE(rig.out(2));
}

TEST(VxmNonstop, TheStoppingIndexOfU92GoesTheWayOfTheMotion) {
  Rig rig = Rig::online();
  rig.send("C");
  rig.send("U77,I1M100,U92,I1M-100,R");
  EXPECT_TRUE(rig.run_until_output("EC", 10s));
  EXPECT_EQ(rig.load(1), 100) << "it does not go on the other way";
  rig.send("K");
  rig.output();
  rig.run("U77,I1M-100,U92,I1M-100,");
  EXPECT_EQ(rig.position(1), -100);
}

}  // namespace hw::vxm::proof
