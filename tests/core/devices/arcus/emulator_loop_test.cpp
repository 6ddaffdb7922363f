// StepNLoop with loads that slip and jam (tables 6.13 and 7.7; decisions AMB-097 to AMB-104).
#include "tests/core/devices/arcus/rig.h"

namespace hw::arcus::proof {
namespace {

constexpr int idle = 0, correcting = 2, range_error = 8, attempt_error = 9, stall = 10, limit_error = 11;

TEST(ArcusLoop, ASlipDuringAMoveIsCorrectedAtItsEnd) {
  Rig rig(Which::dmx);
  rig.ok("X4000");
  rig.run_for(1s);
  rig.slip(0, -200);
  while (rig.number("SLS") == 1) rig.run_for(1ms);
  EXPECT_EQ(rig.number("SLS"), correcting);
  EXPECT_EQ(rig.ask("PX"), "4000") << "the target stays while it corrects";
  EXPECT_EQ(rig.ask("DO"), "2") << "not in position yet";
  rig.run_to_rest();
  EXPECT_EQ(rig.number("SLS"), idle);
  EXPECT_NEAR(rig.number("EX"), 4000, 5);
  EXPECT_EQ(rig.ask("DO"), "3") << "in position";
}

TEST(ArcusLoop, AJammedLoadStallsWhereTheErrorLeavesItsRange) {
  Rig rig(Which::dmx);
  rig.jam(0, true);
  rig.ok("X20000");
  rig.run_to_rest();
  EXPECT_EQ(rig.number("SLS"), stall);
  EXPECT_NEAR(rig.number("DX"), 1001, 1);
  EXPECT_EQ(rig.number("DO") & 4, 4) << "alarm output";
  EXPECT_EQ(rig.ask("X0"), "?State Error");
  rig.jam(0, false);
  rig.ok("CLR");
  EXPECT_EQ(rig.number("SLS"), idle);
  rig.ok("X0");
  rig.run_to_rest();
  EXPECT_EQ(rig.number("SLS"), idle);
  EXPECT_EQ(rig.number("EX"), 0);
}

TEST(ArcusLoop, AtMostSlaCorrections) {
  Rig rig(Which::dmx);
  rig.ok("SLA=3"), rig.ok("X100");
  rig.run_to_rest();
  rig.jam(0, true);
  rig.slip(0, -100);
  int corrections = 0;
  for (bool was = false; rig.number("SLS") != attempt_error && corrections < 10; rig.run_for(100us)) {
    const bool now = rig.number("SLS") == correcting && (rig.number("MST") & 2) != 0;
    corrections += now && !was;
    was = now;
  }
  EXPECT_EQ(rig.number("SLS"), attempt_error);
  EXPECT_EQ(corrections, 3);
  EXPECT_EQ(rig.ask("DX"), "100");
}

TEST(ArcusLoop, ErrorOfExactlySleIsCorrected) {
  Rig rig(Which::pmx);
  rig.ok("SLX=1"), rig.ok("SLEX=500");
  rig.slip(0, 500);
  EXPECT_EQ(rig.number("SLSX"), correcting);
  rig.run_to_rest();
  EXPECT_EQ(rig.ask("EX"), "0");
  rig.slip(0, 501);
  EXPECT_EQ(rig.number("SLSX"), range_error);
}

TEST(ArcusLoop, TheIdleToleranceCausesOneMoreCorrectionWithIdleCurrent) {
  Rig rig(Which::dmx);
  AxisPlace rough;
  rough.counts_per_step = 1.25, rough.backlash = Steps(12);  // a correction falls short by the play
  rig.place(0, rough);
  rig.ok("EO=1"), rig.ok("SLT=30"), rig.ok("SLM=5");
  rig.slip(0, 100);  // it has to come back through the play
  EXPECT_EQ(rig.number("SLS"), correcting);
  EXPECT_EQ(rig.ask("CUR"), "1600");
  bool idle_current = false;
  while ((rig.number("MST") & 7) != 0) {
    idle_current |= rig.ask("CUR") == "1000";
    rig.run_for(1ms);
  }
  EXPECT_TRUE(idle_current);
  EXPECT_LE(std::abs(rig.number("DX")), 5);
  EXPECT_EQ(rig.number("SLS"), idle);
}

TEST(ArcusLoop, ALimitIsState11AndJogIsWatchedToo) {
  Rig rig(Which::dmx);
  AxisPlace place;
  place.plus = Steps(800);
  rig.place(0, place);
  rig.ok("X5000");
  rig.run_to_rest();
  EXPECT_EQ(rig.number("SLS"), limit_error);
  EXPECT_EQ(rig.ask("EX"), "1000");
  EXPECT_EQ(rig.ask("MST"), "160");
  rig.ok("CLR"), rig.ok("J-");
  rig.run_for(100ms);
  rig.jam(0, true);
  rig.run_to_rest();
  EXPECT_EQ(rig.number("SLS"), stall);
}

TEST(ArcusLoop, LinearInterpolationNeedsItOnAllAxesAndCorrectsEach) {
  Rig rig(Which::pmx);
  rig.ok("SLX=1");
  EXPECT_EQ(rig.ask("X100Y100"), "?X100Y100");
  rig.ok("SLY=1");
  EXPECT_EQ(rig.ask("CIRP100:100"), "OK");
  rig.ok("ABORT");
  rig.ok("SLRY=2");
  EXPECT_EQ(rig.ask("CIRP100:100"), "?CIRP100:100") << "the ratios must be the same";
  rig.ok("SLRY=1");
  rig.ok("X1000Y500");
  rig.run_for(500ms);
  rig.slip(1, 60);
  rig.run_to_rest(0);
  rig.run_to_rest(1);
  EXPECT_EQ(rig.ask("PE"), "1000:500:0:0");
  EXPECT_EQ(rig.ask("PP"), "1000:500:0:0");
}

TEST(ArcusLoop, SwitchingItOnAndOffMovesNothing) {
  Rig rig(Which::dmx);
  rig.ok("X1000");
  rig.run_to_rest();
  rig.ok("SL=0");
  EXPECT_EQ(rig.ask("PX"), "800") << "pulses now";
  rig.slip(0, 5000);
  rig.ok("SL=1");
  EXPECT_EQ(rig.number("SLS"), idle);
  EXPECT_EQ(rig.ask("PX"), "6000");
  EXPECT_EQ(rig.ask("DX"), "0");
}

TEST(ArcusLoop, ARatioThatIsWrongIsFoundOut) {
  Rig rig(Which::pmx);
  AxisPlace place;
  place.counts_per_step = 2;
  rig.place(0, place);
  rig.ok("SLX=1");  // the ratio still says one count for a pulse
  rig.ok("X5000");
  rig.run_to_rest();
  EXPECT_EQ(rig.number("SLSX"), stall);
  EXPECT_EQ(rig.ask("DXX"), "-1001");
}

}  // namespace
}  // namespace hw::arcus::proof
