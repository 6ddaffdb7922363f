// Moves in time and place (PMX manual ch. 6, DMX manual ch. 7, both appendices A).
#include "tests/core/devices/arcus/rig.h"

namespace hw::arcus::proof {
namespace {

TEST(ArcusMotion, PmxAnswersAtRestAsInItsManual) {
  Rig rig(Which::pmx);
  EXPECT_EQ(rig.ask("MST"), "0:0:0:0:0:0:0:36:0");
  EXPECT_EQ(rig.ask("POX"), "7");
  EXPECT_EQ(rig.ask("DN"), "4EX00");
  EXPECT_EQ(rig.ask("VER"), "V161BL");
}

TEST(ArcusMotion, DmxAnswersAtRestAsInItsManual) {
  Rig rig(Which::dmx);
  EXPECT_EQ(rig.ask("MST"), "0");
  EXPECT_EQ(rig.ask("SLR"), "0.800");
  EXPECT_EQ(rig.ask("DN"), "DMK01");
  EXPECT_EQ(rig.ask("SL"), "1");
  EXPECT_EQ(rig.ask("SLS"), "0");
}

TEST(ArcusMotion, TrapezoidTakesItsExactTime) {
  Rig rig(Which::pmx);
  rig.ok("HS=10000"), rig.ok("LS=500"), rig.ok("ACC=300");
  rig.ok("X20000");
  EXPECT_TRUE(same_time(rig.run_to_rest(), trapezoid_time(20000, 10000, 500, 300, 300)));
  EXPECT_EQ(rig.ask("PX"), "20000");
  EXPECT_EQ(rig.ask("EX"), "20000");
  rig.ok("X19000");
  EXPECT_TRUE(same_time(rig.run_to_rest(), trapezoid_time(1000, 10000, 500, 300, 300))) << "a triangle";
  EXPECT_EQ(rig.load(0), 19000);
}

TEST(ArcusMotion, SCurveTakesTheTimeOfTheTrapezoid) {
  Rig rig(Which::pmx);
  rig.ok("HS=10000"), rig.ok("LS=500"), rig.ok("SCVX=1");
  rig.ok("X20000");
  rig.run_for(75ms);
  // A quarter of the ramp: an eighth of the change, where a straight ramp had a quarter.
  EXPECT_NEAR(std::stod(rig.ask("PS")), 500 + 9500 / 8.0, 1);
  EXPECT_TRUE(same_time(rig.run_to_rest() + 75ms, trapezoid_time(20000, 10000, 500, 300, 300)));
  EXPECT_EQ(rig.ask("PX"), "20000");
}

// 800 a second by the stick; from 1000 to 2000 the speed allowed falls from 1000 to 0 (decision AMB-081), so
// that from 1200 on it is what is left to go.
TEST(ArcusMotion, TheJoystickSlowsDownBetweenItsSoftLimits) {
  Rig rig(Which::pmx);
  const auto speed = [&] { return std::stod(rig.ask("PS")); };
  const auto place = [&] { return static_cast<double>(rig.number("PX")); };
  rig.ok("JV1=1000"), rig.ok("JV5=50");
  rig.ok("JL1=-2000"), rig.ok("JL2=-1000"), rig.ok("JL3=1000"), rig.ok("JL4=2000");
  rig.analog(1, 4500);
  rig.ok("JE=1");
  rig.run_for(1s);
  EXPECT_NEAR(speed(), 800, 1);
  rig.run_for(863ms);
  EXPECT_NEAR(place(), 1400, 20);
  EXPECT_NEAR(speed(), 2000 - place(), 10);
  rig.run_for(1098ms);
  EXPECT_NEAR(place(), 1800, 10);
  EXPECT_NEAR(speed(), 2000 - place(), 5);
  rig.run_for(10s);
  EXPECT_EQ(rig.ask("PX"), "2000");
  EXPECT_EQ(rig.ask("PS"), "0:0:0:0");
  rig.analog(1, 500);
  rig.run_for(500ms);
  EXPECT_NEAR(speed(), 800, 1) << "not on the way back";
}

// Decision AMB-076: a ring; the newest and the running one are the same again after it has run empty.
TEST(ArcusMotion, TheBuffersPlacesGoRound) {
  Rig rig(Which::pmx);
  const auto fields = [&] { return rig.ask("MST").substr(rig.ask("MST").size() - 10); };
  rig.ok("BO");
  EXPECT_EQ(fields(), "1:0:0:36:0");
  for (const char* segment : {"I100:0:0:1000", "I200:0:0:1000", "I300:0:0:1000"}) rig.ok(segment);
  EXPECT_EQ(fields(), "1:0:2:33:0");
  rig.run_for(5s);
  EXPECT_EQ(rig.ask("PX"), "300");
  EXPECT_EQ(fields(), "1:2:2:36:0");
  rig.ok("I400:0:0:1000");
  EXPECT_EQ(fields(), "1:3:3:35:0");
  rig.ok("I500:0:0:1000");
  EXPECT_EQ(fields(), "1:3:4:34:0");
}

// Motion waits for its axis; a counter would be refused to a host while it moves, and is an error of the
// program (decisions AMB-037, AMB-113, AMB-118).
TEST(ArcusMotion, ACounterWrittenWhileItsAxisMovesIsAnErrorOfTheProgram) {
  for (const Which which : {Which::pmx, Which::dmx}) {
    Rig rig(which);
    int n = 0;
    for (const char* line : {"MOVE,X,500", "SET,PX,0", "SET,V1,1", "END"})
      rig.ok("SA" + std::to_string(n++) + "=" + line);
    rig.ok("SR0=1");
    rig.run_for(100ms);
    EXPECT_EQ(rig.ask("SASTAT0"), "4");
    EXPECT_EQ(rig.ask("SPC0"), "1");
    rig.run_to_rest();
    EXPECT_EQ(rig.ask("PX"), "500");
    EXPECT_EQ(rig.ask("V1"), "0");
  }
}

TEST(ArcusMotion, DmxMovesInCounts) {
  Rig rig(Which::dmx);
  rig.ok("HSPD=4000"), rig.ok("LSPD=1000");
  rig.ok("X8000");
  EXPECT_EQ(rig.ask("SLS"), "1");
  EXPECT_TRUE(same_time(rig.run_to_rest(), trapezoid_time(8000, 4000, 1000, 300, 300)));
  EXPECT_EQ(rig.ask("PX"), "8000");
  EXPECT_EQ(rig.ask("EX"), "8000");
  EXPECT_EQ(rig.load(0), 6400) << "pulses";
  EXPECT_EQ(rig.ask("SLS"), "0");
  EXPECT_EQ(rig.ask("DX"), "0");
}

}  // namespace
}  // namespace hw::arcus::proof
