// The manual's examples 1 to 12 and 14 to 18 (number 13 is missing from the printed text) and those of the
// appendices, from their text. What they have to do follows from the rules; V33, V37 to V53 say where the
// text leaves room. In examples/ doubled letters of the printed example 12 (U5U5, P2P2) are taken once.
#include <cmath>
#include <fstream>
#include <sstream>

#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {
namespace {

using Positions = std::vector<std::int64_t>;
using Place = std::pair<std::int64_t, std::int64_t>;  // motor 1, motor 2

std::string text_of(const std::string& name) {
  std::ifstream file(HW_TEST_DIR "/core/devices/vxm/examples/" + name);
  EXPECT_TRUE(file.good()) << name;
  std::string all;
  for (std::string line; std::getline(file, line);) all += line + "\r";
  return all;
}

int used(Rig& rig, char program) {
  rig.send(std::string("PM") + program + ",");
  const int bytes = rig.used_bytes();
  rig.send("PM0,");
  return bytes;
}

Rig loaded(const std::string& name, const DeviceOptions& options = {}) {
  Rig rig(options);
  rig.send(text_of(name));
  rig.send("F");
  rig.output();
  return rig;
}

// Where motors 1 and 2 stand whenever output 1 falls (a part let go) and rises (a part gripped).
struct Grips {
  std::vector<Place> picked, placed;
};
Grips run_watching_the_gripper(Rig& rig, std::string_view until = "^") {
  Grips seen;
  rig.send("R");
  bool gripped = false;
  std::string out;
  for (const Duration end = rig.elapsed() + 1h; rig.elapsed() < end;) {
    if (const bool now = rig.out(1); now != gripped) {
      (now ? seen.picked : seen.placed).emplace_back(rig.load(1), rig.load(2));
      gripped = now;
    }
    out += rig.output();
    if (out.find(until) != std::string::npos) return seen;
    const auto next = rig.emulator().next_event();
    if (!next) break;
    rig.run_for(std::max(next->time_since_epoch() - rig.elapsed(), Duration(1)));
  }
  ADD_FAILURE() << "no prompt; output " << visible(out);
  return seen;
}

std::vector<Place> rows(const std::vector<std::int64_t>& x, const std::vector<std::int64_t>& y) {
  std::vector<Place> all;
  for (const auto row : y)
    for (const auto column : x) all.emplace_back(column, row);
  return all;
}

}  // namespace

TEST(VxmExample, 1_OnLine) {
  Rig rig;
  EXPECT_EQ(rig.ask("E"), "E");
  EXPECT_EQ(rig.ask("V"), "VR");
}

TEST(VxmExample, 2_IncrementalIndex) {
  for (const char* text : {"I1M400,R", "I1M400\rR"}) {
    Rig rig = Rig::online();
    rig.send(text);
    EXPECT_TRUE(rig.run_until_output("^"));
    EXPECT_EQ(rig.position(1), 400);
    EXPECT_EQ(rig.used_bytes(), 4);
  }
}

TEST(VxmExample, 3_Clear) {
  Rig rig = Rig::online();
  rig.send("I1M400,C");
  EXPECT_EQ(rig.used_bytes(), 0);
}

TEST(VxmExample, 4_NegativeIndex) {
  Rig rig = Rig::online();
  rig.send("I2M-600,R");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.position(2), -600);
  EXPECT_EQ(rig.used_bytes(), 4);
}

TEST(VxmExample, 5_AutoReverse) {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("I1M800,I-800,"), 2 * index_time(800)));
  EXPECT_EQ(rig.position(1), 0);
  EXPECT_EQ(rig.used_bytes(), 8);
}

TEST(VxmExample, 6_RepeatingIndex) {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("P10,I1M400,L10,I1M-3600,"), 10s + 9 * index_time(400) + index_time(3600)));
  EXPECT_EQ(rig.position(1), 0) << "returns to its start";
  EXPECT_EQ(rig.used_bytes(), 14);
}

TEST(VxmExample, 7_HomeToLimit) {
  Rig rig = Rig::online();
  AxisPlace travel;
  travel.plus = Steps(3000);
  rig.place(1, travel);
  rig.run("S1M600,I1M0,I1M-200,IA1M-0,");
  EXPECT_EQ(rig.position(1), 0);
  EXPECT_EQ(rig.load(1), 2800);
  EXPECT_EQ(rig.used_bytes(), 15);
}

TEST(VxmExample, 8_RasterScan) {
  Rig rig = Rig::online();
  rig.send("I1M200, P10, L7, I2M400, L-4, U6, LM-2, ");
  EXPECT_EQ(rig.used_bytes(), 20) << "printed 23, its commands add up to 20 (V33)";
  const Duration row = 7 * index_time(200) + 6s, scan = 4 * row + 3 * index_time(400);
  const Duration start = rig.elapsed();
  rig.send("R");
  EXPECT_TRUE(rig.run_until_output("W"));
  EXPECT_TRUE(same_time(rig.elapsed() - start, scan, 20us));
  rig.output();
  EXPECT_EQ(rig.ask("XY"), "+0000000\r+0001200\r");
  rig.send("G");
  EXPECT_TRUE(rig.run_until_output("W")) << "the body, with its U6, runs once more";
  EXPECT_TRUE(same_time(rig.elapsed() - start, 2 * scan, 40us));
  rig.output();
  EXPECT_EQ(rig.ask("XY"), "+0000000\r+0000000\r") << "back over the same path";
  EXPECT_EQ(rig.ask("G"), "^");
}

TEST(VxmExample, 9_Rectangle) {
  Rig rig = Rig::online();
  rig.send("I1M2000, U1, I2M1000, U1, LM-3, L0, ");
  EXPECT_EQ(rig.used_bytes(), 14);
  rig.send("R");
  const std::vector<Place> corners = {{2000, 0}, {2000, 1000}, {0, 1000}, {0, 0}, {2000, 0}, {2000, 1000}};
  for (const Place& corner : corners) {
    rig.run_for(10s);
    EXPECT_EQ(Place(rig.load(1), rig.load(2)), corner);
    EXPECT_TRUE(rig.out(1)) << "waits with output 1 high at each corner";
    rig.pulse_input(1, 5ms);
    rig.run_for(1ms);
  }
  EXPECT_EQ(rig.ask("V"), "B");
}

TEST(VxmExample, 10_RasterScans) {
  const std::string scans = "I1M2000, I2M300, L-4, LM0, I2M600, I1M3000, L-3, IA2M0";
  Rig rig = Rig::online();
  const Duration once = rig.run(scans + "\r");
  EXPECT_TRUE(same_time(once,
                        4 * index_time(2000) + 3 * index_time(300) + 3 * index_time(600) +
                            2 * index_time(3000) + index_time(2700),
                        10us));
  EXPECT_EQ(rig.ask("XY"), "+0000000\r+0000000\r");
  EXPECT_EQ(rig.used_bytes(), 27);
  EXPECT_TRUE(same_time(rig.run(scans + ", LM-0, LA5\r"), 5 * once, 50us)) << "the same pattern five times";
  EXPECT_EQ(rig.ask("XY"), "+0000000\r+0000000\r");
  EXPECT_EQ(rig.used_bytes(), 31);
}

TEST(VxmExample, 11_Matrix) {
  Rig rig = Rig::online_with_slave();
  const Duration took = rig.run("I3M2000, I3M-2000, I1M1600, L5, I2M400, L-3, IA1M0, IA2M0, ");
  EXPECT_TRUE(same_time(took,
                        30 * index_time(2000) + 12 * index_time(1600) + 2 * index_time(400) +
                            index_time(6400) + index_time(800),
                        100us));
  EXPECT_EQ(rig.ask("XYZ"), "+0000000\r+0000000\r+0000000\r");
  EXPECT_EQ(rig.used_bytes(), 30);
}

TEST(VxmExample, 12_PickAndPlaceInARow) {
  Rig rig = loaded("example_12.vxm");
  EXPECT_EQ(used(rig, '1'), 9);
  EXPECT_EQ(used(rig, '0'), 27);
  const Grips g = run_watching_the_gripper(rig);
  EXPECT_EQ(g.placed, (std::vector<Place>{{1000, 0},
                                          {1800, 0},
                                          {2600, 0},
                                          {3400, 0},
                                          {4200, 0},
                                          {5000, 0},
                                          {5800, 0},
                                          {6600, 0},
                                          {7400, 0},
                                          {8200, 0},
                                          {0, 0}}));
  EXPECT_EQ(g.picked, std::vector<Place>(11, Place(0, 0)));
  EXPECT_EQ(rig.position(1), 0);
  EXPECT_FALSE(rig.out(1)) << "ends with the part not gripped";
}

TEST(VxmExample, 14_PickAndPlaceInTwoRows) {
  Rig rig = loaded("example_14.vxm");
  EXPECT_EQ(used(rig, '2'), 9);
  EXPECT_EQ(used(rig, '1'), 11);
  EXPECT_EQ(used(rig, '0'), 51);
  const Grips g = run_watching_the_gripper(rig);
  auto placed = rows({1600, 2400, 3200, 4000, 4800}, {0, 1200});
  placed.emplace_back(0, 0);
  EXPECT_EQ(g.placed, placed);
  EXPECT_EQ(g.picked.size(), 11u);
  for (const Place& p : g.picked) EXPECT_EQ(p.first, 0);
  EXPECT_EQ(rig.ask("XY"), "+0000000\r+0000000\r");
  EXPECT_FALSE(rig.out(1));
}

TEST(VxmExample, 15_PickAndPlaceInThreeRowsWithThreeMotors) {
  Rig rig = loaded("example_15.vxm", {{"motors", "4"}});
  EXPECT_EQ(used(rig, '2'), 17);
  EXPECT_EQ(used(rig, '1'), 19);
  EXPECT_EQ(used(rig, '3'), 24);
  EXPECT_EQ(used(rig, '0'), 27);
  rig.send("R");
  for (int tray = 0; tray < 2; ++tray) {
    std::vector<Place> placed;
    for (bool gripped = false; static_cast<int>(placed.size()) < 15;) {
      const bool now = rig.out(1);
      if (gripped && !now) placed.emplace_back(rig.load(1), rig.load(2));
      gripped = now;
      rig.run_for(1ms);
      ASSERT_LT(rig.elapsed(), 1h);
    }
    EXPECT_EQ(placed, rows({1600, 2400, 3200, 4000, 4800}, {0, 1200, 2400}));
    rig.run_for(30s);
    EXPECT_EQ(rig.ask("V"), "B") << "waits for the operator";
    EXPECT_EQ(rig.ask("XYZ"), "+0000000\r+0000000\r+0000000\r");
    rig.click("Run");
  }
  EXPECT_EQ(rig.ask("K"), "^");
}

TEST(VxmExample, 16_PickFromRowsAndPlaceAtOnePoint) {
  Rig rig = loaded("example_16.vxm", {{"motors", "4"}});
  EXPECT_EQ(used(rig, '2'), 27);
  EXPECT_EQ(used(rig, '1'), 9);
  EXPECT_EQ(used(rig, '0'), 41);
  const Grips g = run_watching_the_gripper(rig);
  EXPECT_EQ(g.picked, rows({0, 800, 1600, 2400, 3200}, {0, 1200}));
  EXPECT_EQ(g.placed, rows({-1000, -1000, -1000, -1000, -1000}, {0, 1200}));
  EXPECT_EQ(rig.ask("XYZ"), "+0000000\r+0000000\r+0000000\r");
}

TEST(VxmExample, 17_ChangeSpeed) {
  for (const bool low : {false, true}) {
    Rig rig = loaded("example_17.vxm");
    EXPECT_EQ(rig.used_bytes(), 18);
    rig.input(1, low);
    rig.run_for(10ms);
    EXPECT_TRUE(same_time(rig.run_program(), 2 * index_time(8000, low ? 2000 : 4000)));
    EXPECT_EQ(rig.position(1), 0);
  }
}

TEST(VxmExample, 18_ChangeProgram) {
  Rig rig = loaded("example_18.vxm");
  EXPECT_EQ(used(rig, '1'), 7);
  EXPECT_EQ(used(rig, '0'), 11);
  EXPECT_TRUE(same_time(rig.run_program(), index_time(8000, 2000)));
  EXPECT_EQ(rig.position(1), 8000);
  rig.input(2, true);
  rig.run_for(10ms);
  EXPECT_TRUE(same_time(rig.run_program(), index_time(8000, 4000))) << "program 1 runs the motor to zero";
  EXPECT_EQ(rig.position(1), 0);
}

TEST(VxmExample, AppendixC_BinarySelection) {
  Rig rig = Rig::online();
  rig.send("setI67,");
  EXPECT_EQ(rig.ask("getI"), "67\r");
}

TEST(VxmExample, AppendixD_IndexStopOutput) {
  Rig rig = Rig::online();
  rig.send("I1M400, PA10, R");
  rig.run_for(index_time(400) + 1ms);
  EXPECT_EQ(rig.position(1), 400);
  EXPECT_TRUE(rig.out(1));
  rig.run_for(998ms);
  EXPECT_TRUE(rig.out(1));
  EXPECT_TRUE(rig.run_until_output("^", 2ms));
  EXPECT_FALSE(rig.out(1));
  EXPECT_EQ(rig.used_bytes(), 7);
}

TEST(VxmExample, AppendixD_ContinuousIndexes) {
  Rig one = Rig::online();
  one.run("S1M1500,U7,I1M1000,I1M100,I1M50,I1M100,U9,IA1M0\r");
  EXPECT_EQ(one.pulse_positions(1), (Positions{1000, 1100, 1150, 1250}));
  EXPECT_EQ(one.position(1), 0);
  EXPECT_EQ(one.used_bytes(), 3 + 2 + 16 + 2 + 4);

  Rig two = Rig::online();
  two.run("U7,I2M400,LA100,U9\r");
  EXPECT_EQ(two.pulse_positions(2).size(), 100u);
  EXPECT_EQ(two.pulse_positions(2).back(), 40000);
  EXPECT_EQ(two.position(2), 41000);
  EXPECT_EQ(two.used_bytes(), 11);

  Rig three = Rig::online();
  three.run("S2M1500,U7,I2M2000,S2M3000,I2M4000,S2M500,I2M800,U9,S2M3000,IA2M0\r");
  EXPECT_EQ(three.pulse_positions(2), (Positions{2000, 6000, 6800}));
  EXPECT_EQ(three.position(2), 0);
  EXPECT_EQ(three.used_bytes(), 32);
}

TEST(VxmExample, AppendixD_PulsesEveryNSteps) {
  struct Setting {
    const char* set;
    int motor;
    Positions first;
  };
  for (const Setting& s : {Setting{"setP1M4\r", 1, {2, 6, 10}}, Setting{"setP1M2\r", 1, {1, 3, 5}},
                           Setting{"setP2M3\r", 2, {2, 5, 8}}, Setting{"setP1M5\r", 1, {3, 8, 13}}}) {
    Rig rig = Rig::online();
    rig.send(s.set);
    rig.run(s.motor == 1 ? "I1M20," : "I2M20,");
    Positions at = rig.pulse_positions(s.motor);
    ASSERT_GE(at.size(), 3u) << s.set;
    at.resize(3);
    EXPECT_EQ(at, s.first) << s.set;
  }
  for (const auto& [set, width] : {std::pair{"setPA4\r", Duration(40us)}, {"setPA200\r", Duration(2ms)}}) {
    Rig rig = Rig::online();
    rig.send(set);
    rig.run("U7,I1M100,U9,");
    ASSERT_EQ(rig.pulses().size(), 1u);
    EXPECT_EQ(rig.pulses()[0].width, width) << set;
  }
}

TEST(VxmExample, AppendixG_TwoControllers) {
  Rig rig = Rig::online_with_slave();
  EXPECT_TRUE(same_time(rig.run("I1M400,I3M800,"), index_time(400) + index_time(800))) << "sequentially";
  EXPECT_TRUE(same_time(rig.run("(I3M800,I1M400,)"), index_time(800))) << "at the same time";
  EXPECT_EQ(rig.used_bytes(), 10);
  EXPECT_TRUE(same_time(rig.run("(I1M400,I3M800,)"), index_time(400) + index_time(800)))
      << "crossed out, p.47";
}

TEST(VxmExample, AppendixH_Digitizing) {
  Rig rig = Rig::online_with_slave();
  rig.run("I1M201,I2M-1294010,I4M80000,");
  rig.send("Q");
  EXPECT_EQ(visible(rig.ask("D")), "X+0000201<cr>Y-1294010<cr>Z+0000000<cr>T+0080000<cr>");
}

TEST(VxmExample, AppendixI_SpeedFromTheAnalogInput) {
  for (const auto& [reading, speed] : {std::pair{0, 1000}, {512, 2000}, {1024, 3000}}) {
    Rig rig = Rig::online();
    rig.analog(1, reading);
    EXPECT_TRUE(same_time(rig.run("S1M-12\rI1M8000\r"), index_time(8000, speed)));
    EXPECT_EQ(visible(rig.ask("lst")), "PM0 M249<cr>S1M" + std::to_string(speed) + "<cr>I1M8000<cr>");
  }
}

TEST(VxmExample, AppendixN_HomeSwitch) {
  Rig one = Rig::online();
  AxisPlace magnet;
  magnet.home_from = Steps(-3000);
  magnet.home_to = Steps(-2000);
  one.place(1, magnet);
  one.send("setL1M-2\r");
  one.send("C S1M600, I1M-0, I1M4000, I1M-0, IA1M-0, R");
  EXPECT_TRUE(one.run_until_output("^"));
  EXPECT_EQ(one.position(1), 0);
  EXPECT_EQ(one.load(1), -2000);
  EXPECT_EQ(one.used_bytes(), 19);

  Rig two = Rig::online();
  magnet.home_from = Steps(2000);
  magnet.home_to = Steps(3000);
  two.place(2, magnet);
  two.send("setL2M-2\r");
  two.send("C S2M800, I2M0, I2M-4000, I2M0, I 2M-1000, IA2M-0, R");
  EXPECT_TRUE(two.run_until_output("^"));
  EXPECT_EQ(two.position(2), 0);
  EXPECT_EQ(two.load(2), 1000) << "1000 steps away from the switch";
}

TEST(VxmExample, AppendixT_ConditionalBranchOnInputThree) {
  Rig rig = Rig::online();
  rig.send("PM3,I2M5,PM0,U0,I1M9,R");
  rig.run_for(1s);
  rig.input(3, true);
  EXPECT_TRUE(rig.run_until_output("^", 10s));
  EXPECT_EQ(rig.ask("XY"), "+0000000\r+0000005\r");
}

TEST(VxmExample, LinkingChapter_MotorThree) {
  Rig rig = Rig::online_with_slave();
  rig.send("C I3M400,R");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.position(3), 400);
}

}  // namespace hw::vxm::proof
