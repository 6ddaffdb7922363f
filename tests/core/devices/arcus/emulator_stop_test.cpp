// What a stop leaves behind: where an axis rests, how long its ramp takes, what has been written meanwhile.
#include "tests/core/devices/arcus/rig.h"

namespace hw::arcus::proof {
namespace {

/// Until the axis rests; whether StepNLoop has corrected on the way there.
bool corrects_before_rest(Rig& rig, const std::string& axis = "") {
  bool corrected = false;
  for (int i = 0; i < 20'000 && (rig.number("MST" + axis) & 7) != 0; ++i) {
    corrected |= rig.number("SLS" + axis) == 2;
    rig.run_for(1ms);
  }
  return corrected;
}

// --- StepNLoop verifies only a targeted move that ends by itself (DMX manual ch. 7, PMX manual ch. 6) ------

TEST(ArcusStop, AnAbortedCorrectionIsNotTakenUpAgain) {
  Rig rig(Which::dmx);
  rig.ok("X1000");
  rig.run_to_rest();
  rig.slip(0, -800);
  rig.run_for(200ms);
  ASSERT_EQ(rig.ask("SLS"), "2");
  rig.ok("ABORT");
  EXPECT_EQ(rig.ask("SLS"), "4") << "for one update";
  const std::string here = rig.ask("EX");
  EXPECT_EQ(rig.ask("MST"), "0");
  rig.run_for(1s);
  EXPECT_EQ(rig.ask("SLS"), "0");
  EXPECT_EQ(rig.ask("EX"), here);
  EXPECT_EQ(rig.ask("PX"), here) << "its target now";
  rig.slip(0, 100);
  EXPECT_EQ(rig.ask("SLS"), "2") << "what disturbs it at rest is corrected as ever";
}

TEST(ArcusStop, AStoppedCorrectionIsNotTakenUpAgain) {
  Rig rig(Which::pmx);
  rig.ok("SLX=1");
  rig.slip(0, -800);
  rig.run_for(300ms);
  ASSERT_EQ(rig.ask("SLSX"), "2");
  rig.ok("STOPX");
  EXPECT_EQ(rig.ask("SLSX"), "3");
  EXPECT_FALSE(corrects_before_rest(rig, "X"));
  EXPECT_LT(rig.number("EX"), -10);
  EXPECT_EQ(rig.ask("PX"), rig.ask("EX"));
  EXPECT_EQ(rig.ask("SLSX"), "0");
}

TEST(ArcusStop, AJammedAxisLetsItsLoopBeSwitchedOffAfterAnAbort) {
  Rig rig(Which::pmx);
  rig.ok("SLX=1");
  rig.jam(0, true);
  rig.ok("X500");
  rig.run_for(2s);
  rig.ok("ABORT");
  EXPECT_EQ(rig.ask("SLX=0"), "OK");
}

TEST(ArcusStop, MovesJogsAndLinesRestWhereTheyAreStopped) {
  for (const char* move : {"X5000", "JX+", "X5000Y2500"})
    for (const char* end : {"STOP", "ABORT"}) {
      Rig rig(Which::pmx);
      rig.ok("SLX=1"), rig.ok("SLY=1"), rig.ok(move);
      rig.run_for(1s);
      rig.slip(0, -300);
      rig.ok(end);
      EXPECT_FALSE(corrects_before_rest(rig, "X")) << move << " " << end;
      EXPECT_EQ(rig.ask("DXX"), "0") << move << " " << end;
      EXPECT_EQ(rig.ask("PX"), rig.ask("EX")) << move << " " << end;
    }
}

TEST(ArcusStop, TheLoopSwitchedOnAgainTakesThePlaceAsItsTarget) {
  Rig rig(Which::dmx);
  rig.jam(0, true);
  rig.ok("X5000");
  rig.run_to_rest();
  ASSERT_EQ(rig.ask("SLS"), "10");
  rig.ok("SL=1");
  EXPECT_EQ(rig.ask("SLS"), "0");
  EXPECT_EQ(rig.ask("DX"), "0");
}

TEST(ArcusStop, ARatioWrittenDuringAMoveIsLookedAtOnce) {
  Rig rig(Which::dmx);
  rig.ok("HSPD=5000"), rig.ok("X50000");
  rig.run_for(1s);
  rig.ok("SLR=2.0");
  EXPECT_EQ(rig.ask("SLS"), "10");
  EXPECT_EQ(rig.ask("MST"), "0");
}

TEST(ArcusStop, NoBufferedMoveUnderStepNLoop) {
  Rig rig(Which::pmx);
  rig.ok("BO"), rig.ok("SLY=1");
  EXPECT_EQ(rig.ask("I1000:0:0:500"), "?I1000:0:0:500");
  rig.ok("SLY=0"), rig.ok("I1000:0:0:500");
}

// --- the ramp is that of the motion's start (decisions AMB-047, AMB-054) -----------------------------------

TEST(ArcusStop, SpeedsWrittenDuringAMotionLeaveItsRampAlone) {
  for (const char* meanwhile : {"HS=200", "HS=60000", "ACC=20"}) {
    for (const char* move : {"JX+", "X300000", "X30000Y40000"}) {
      Rig rig(Which::pmx);
      rig.ok("HS=5000"), rig.ok("ACC=1000"), rig.ok(move);
      rig.run_for(2s);
      rig.ok(meanwhile), rig.ok("STOP");
      EXPECT_TRUE(same_time(rig.run_to_rest(), 1s, 1ms)) << move << " " << meanwhile;
    }
  }
}

TEST(ArcusStop, ABufferedMoveStopsInAcc) {
  Rig rig(Which::pmx);
  rig.ok("BO"), rig.ok("I60000:0:0:20000");
  rig.run_for(1s);
  rig.ok("STOP");
  EXPECT_TRUE(same_time(rig.run_to_rest(), 300ms, 1ms));
  EXPECT_NEAR(rig.number("PX"), 20000 + (20000 + 100) / 2 * 0.3, 5);
}

TEST(ArcusStop, AStopAfterASpeedChangeTakesAcc) {
  Rig rig(Which::pmx);
  rig.ok("SSPDMX=1"), rig.ok("JX+");
  rig.run_for(1s);
  rig.ok("SSPDX=20000");
  rig.run_for(1s);
  rig.ok("HS=500"), rig.ok("STOPX");
  EXPECT_TRUE(same_time(rig.run_to_rest(), 300ms, 1ms));
}

TEST(ArcusStop, AStopWhileTheSpeedStillFallsTakesAccFromThere) {
  for (const auto& [edec, ramp] : {std::pair("EDEC=0", 1s), std::pair("EDEC=1", 2s)}) {
    Rig rig(Which::pmx);
    for (const char* c : {"HS=20000", "ACC=1000", "DEC=2000", edec, "SSPDMX=1", "JX+"}) rig.ok(c);
    rig.run_for(3s);
    rig.ok("SSPDX=150");
    rig.run_for(100ms);
    rig.ok("STOPX");
    EXPECT_TRUE(same_time(rig.run_to_rest(), ramp, 2ms)) << edec;
  }
}

TEST(ArcusStop, HomingRampsAsItBegan) {
  Rig rig(Which::pmx);
  rig.ok("HS=5000"), rig.ok("ACC=1000"), rig.ok("HX+0");
  rig.run_for(2s);
  rig.ok("HS=200");
  rig.home_switch(0, true);
  EXPECT_TRUE(same_time(rig.run_to_rest(), 1s, 1ms));
}

TEST(ArcusStop, ANewDestinationLeavesTheSpeed) {
  Rig rig(Which::pmx);
  rig.ok("X50000");
  rig.run_for(1s);
  rig.ok("HS=8000"), rig.ok("TX60000");
  rig.run_for(1s);
  EXPECT_EQ(rig.ask("PS"), "1000:0:0:0");
}

TEST(ArcusStop, TurningRoundKeepsTheSpeedThatWasChanged) {
  Rig rig(Which::pmx);
  rig.ok("SSPDMX=1"), rig.ok("X20000");
  rig.run_for(1s);
  rig.ok("SSPDX=5000");
  rig.run_for(1s);
  rig.ok("TX0");
  rig.run_for(700ms);
  EXPECT_EQ(rig.ask("PS"), "5000:0:0:0");
  rig.ok("TX15000");
  rig.run_for(50ms);
  rig.ok("SSPDX=3000");
  rig.run_for(700ms);
  EXPECT_EQ(rig.ask("PS"), "3000:0:0:0");
}

// --- sync outputs and the buffer's fields ------------------------------------------------------------------

// Nothing has passed the position; only where the counter stands then counts (decision AMB-086).
TEST(ArcusStop, AWrittenCounterStepsOverNoSyncPosition) {
  Rig rig(Which::dmx);
  rig.ok("SYNC=1"), rig.ok("SYNP=3000"), rig.ok("SYNO"), rig.ok("EX=5000");
  EXPECT_EQ(rig.ask("SYNS"), "1");
  rig.ok("PX=0");
  EXPECT_EQ(rig.ask("SYNS"), "1");
  rig.ok("EX=9000"), rig.ok("L-");
  rig.limit(0, '-', true);
  rig.limit(0, '-', false);
  rig.run_to_rest();
  EXPECT_EQ(rig.ask("EX"), "0");
  EXPECT_EQ(rig.ask("SYNS"), "1");
  rig.ok("EX=3000");
  EXPECT_EQ(rig.ask("SYNS"), "2");
}

TEST(ArcusStop, ABufferTurnedOnAgainCountsTheSegmentThatRuns) {
  Rig rig(Which::pmx);
  for (const char* c : {"BO", "I1000:0:0:500", "I2000:0:0:500", "BF", "BO", "I3000:0:0:500"}) rig.ok(c);
  const auto fields = [&] { return rig.ask("MST").substr(rig.ask("MST").size() - 10); };
  EXPECT_EQ(fields(), "1:0:1:34:0");
  rig.run_for(20s);
  EXPECT_EQ(rig.ask("PX"), "3000");
  EXPECT_EQ(fields(), "1:1:1:36:0");
}

TEST(ArcusStop, ANewDestinationWhileTheSpeedFallsIsNoSlowerRamp) {
  for (const char* target : {"TX0", "TX60000"}) {
    Rig rig(Which::pmx);
    rig.ok("HS=20000"), rig.ok("ACC=1000"), rig.ok("SSPDMX=1"), rig.ok("X100000");
    rig.run_for(2s);
    rig.ok("SSPDX=150");
    rig.run_for(100ms);
    rig.ok(target);
    rig.run_for(100ms);
    rig.ok("STOPX");
    rig.run_for(1100ms);
    EXPECT_EQ(rig.ask("MSTX"), "0") << target;
  }
}

}  // namespace
}  // namespace hw::arcus::proof
