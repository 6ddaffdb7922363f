// Moves in time and place (PMX manual ch. 6, DMX manual ch. 7, both appendices A).
#include "tests/core/devices/arcus/rig.h"

namespace hw::arcus::proof {
namespace {

TEST(ArcusMotion, PmxAnswersAtRestAsItsManualSays) {
  Rig rig(Which::pmx);
  EXPECT_EQ(rig.ask("MST"), "0:0:0:0:0:0:0:36:0");
  EXPECT_EQ(rig.ask("POX"), "7");
  EXPECT_EQ(rig.ask("DN"), "4EX00");
  EXPECT_EQ(rig.ask("VER"), "V161BL");
}

TEST(ArcusMotion, DmxAnswersAtRestAsItsManualSays) {
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
