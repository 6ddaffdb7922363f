// Loops, markers and jumps together (p.20, 21; App. S; decisions V37 to V53).
#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {
namespace {

Duration t(std::int64_t steps) { return index_time(steps); }

}  // namespace

TEST(VxmLoops, NestedLoopsMultiply) {
  Rig rig = Rig::online();
  rig.run("I1M1,LA5,LA4,");
  EXPECT_EQ(rig.position(1), 20) << "consecutive loops: the product of their counts (p.20)";
  rig.run("IA1M-0,I1M1,LA3,I2M1,LA4,");
  EXPECT_EQ(rig.position(1), 1) << "both loops go back to the start, over IA1M-0";
  EXPECT_EQ(rig.position(2), 4);
}

TEST(VxmLoops, TheInnerLoopStartsAfreshEachTime) {
  Rig rig = Rig::online();
  rig.run("I1M1,L3,I2M1,L2,");
  EXPECT_EQ(rig.position(1), 4) << "2 of 3 in each of two passes";
  EXPECT_EQ(rig.position(2), 1);
  rig.run("");
  rig.run("N");
  EXPECT_EQ(rig.position(1), 0);
}

TEST(VxmLoops, OnlyTheAdjacentCommandIsLeftOut) {
  Rig rig = Rig::online();
  rig.run("I1M1,LA2,L3,");
  EXPECT_EQ(rig.position(1), 6) << "a loop command is no neighbour to leave out (V38)";
  Rig marker = Rig::online();
  marker.run("I1M1,LM-0,L3,");
  EXPECT_EQ(marker.position(1), 3) << "nor is a marker";
}

TEST(VxmLoops, PausesWaitsAndJumpsCanBeLeftOut) {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("I1M1,P10,L3,"), 3 * t(1) + 2s)) << "V39";
  Rig jump = Rig::online();
  jump.send("PM1,I2M1,PM0,");
  jump.run("I1M1,JM1,L3,");
  EXPECT_EQ(jump.position(1), 3);
  EXPECT_EQ(jump.position(2), 2);
  Rig wait = Rig::online();
  wait.send("I1M1,U6,L2,R");
  EXPECT_TRUE(wait.run_until_output("W"));
  wait.send("G");
  EXPECT_TRUE(wait.run_until_output("^", 10s)) << "asked once only";
}

TEST(VxmLoops, APairIsLeftOutAsOne) {
  Rig rig = Rig::online_with_slave();
  rig.run("I2M1,(I3M10,I1M20,)L3,");
  EXPECT_EQ(rig.position(1), 40);
  EXPECT_EQ(rig.position(2), 3);
  EXPECT_EQ(rig.position(3), 20);
}

TEST(VxmLoops, ReversalTouchesRelativeIndexesOfMotorOneOnly) {
  Rig rig = Rig::online();
  AxisPlace travel;
  travel.minus = Steps(-50);
  rig.place(1, travel);
  rig.run("IA1M100,I1M7,I2M5,LA-2,");
  EXPECT_EQ(rig.position(1), 93) << "the absolute index as it stands, 7 back";
  EXPECT_EQ(rig.position(2), 10);
  rig.run("I1M-0,I1M20,LA-2,");
  EXPECT_EQ(rig.position(1), -50)
      << "a home move keeps its way, 20 further into the switch does not start (V42)";
}

TEST(VxmLoops, ReversalReachesIntoJumpedPrograms) {
  Rig rig = Rig::online();
  rig.send("PM1,I1M10,I2M3,PM0,");
  rig.run("JM1,LA-2,");
  EXPECT_EQ(rig.position(1), 0) << "the caution of p.21";
  EXPECT_EQ(rig.position(2), 6);
  rig.run("JM1,LM-3,");
  EXPECT_EQ(rig.position(1), 0);
  EXPECT_EQ(rig.position(2), 6);
}

TEST(VxmLoops, ButNotIntoPickAndPlacePrograms) {
  Rig rig = Rig::online();
  rig.send("PM1,I1M10,PM0,");
  rig.run("JM-1,P0,LA-2,");
  EXPECT_EQ(rig.position(1), 20) << "App. S, 1.";
}

TEST(VxmLoops, NestedReversalsCombine) {
  Rig rig = Rig::online();
  // Passes of the inner loop: + -, in the mirrored body of LM-3: - +.
  rig.run("I1M10,I2M1,LA-3,LM-3,");
  EXPECT_EQ(rig.position(1), 0);
  EXPECT_EQ(rig.position(2), 0);
  Rig once = Rig::online();
  once.run("I1M10,LA-3,I1M100,LM-3,I1M1000,");
  EXPECT_EQ(once.position(1), 1000) << "10+100 there, as much back, unreversed at the end";
}

TEST(VxmLoops, AMarkerCountsByItsPlaceInTheListing) {
  Rig rig = Rig::online();
  rig.run("I1M1,LA2,LM0,I2M1,LA3,");
  EXPECT_EQ(rig.position(1), 2) << "a loop above the marker goes to the start";
  EXPECT_EQ(rig.position(2), 3);
  Rig two = Rig::online();
  two.run("I1M1,LM0,I1M10,LA2,LM0,I1M100,LA3,");
  EXPECT_EQ(two.position(1), 321) << "the nearest marker above";
}

TEST(VxmLoops, TheMirroredPassIsArmedAgain) {
  Rig rig = Rig::online();
  rig.run("I1M10,I2M3,LM-3,LA4,I1M1,");
  EXPECT_EQ(rig.position(1), 1);
  EXPECT_EQ(rig.position(2), 0) << "V43";
}

TEST(VxmLoops, TenNestedAreFineElevenAreTooMany) {
  Rig rig = Rig::online();
  rig.run("I1M1,LA2,LA2,LA2,LA2,LA2,LA2,LA2,LA2,LA2,LA2,");
  EXPECT_EQ(rig.position(1), 1024);
  rig.send("LA2,R");
  EXPECT_TRUE(rig.run_until_output("EL"));
  EXPECT_EQ(rig.output(), "EL");
  rig.run_for(10s);
  EXPECT_EQ(rig.ask("V"), "");
  EXPECT_EQ(rig.output(), "") << "no prompt before K";
  EXPECT_EQ(rig.ask("K"), "^");
  EXPECT_EQ(rig.ask("V"), "R");
  EXPECT_EQ(rig.used_bytes(), 4 + 11 * 3);
}

TEST(VxmLoops, EndlessLoopsAndMarkersDoNotCount) {
  Rig rig = Rig::online();
  rig.send("I1M1,LM0,LM0,LM0,LM0,LM0,LM0,LM0,LM0,LM0,LM0,LM0,LM0,P1,L0,R");
  rig.run_for(1min);
  EXPECT_EQ(rig.ask("V"), "B");
}

TEST(VxmLoops, LoopsOfAJumpedProgramAreItsOwn) {
  Rig rig = Rig::online();
  rig.send("PM1,I2M1,LA3,PM0,");
  rig.run("I1M1,JM1,LA2,");
  EXPECT_EQ(rig.position(1), 2);
  EXPECT_EQ(rig.position(2), 6);
}

TEST(VxmLoops, JumpsChainProgramsAndTheChainReturnsToItsCaller) {
  Rig rig = Rig::online();
  rig.send("PM1,I1M1,J2,PM2,I1M10,J3,PM3,I1M100,PM0,");
  rig.run("JM1,I2M5,");
  EXPECT_EQ(rig.position(1), 111);
  EXPECT_EQ(rig.position(2), 5) << "V47";
  rig.send("PM1,C");
  rig.send("I1M1,J2,PM2,CI1M1,J3,PM3,CI1M1,J4,PM4,I1M1,PM0,");
  rig.run("N");
  rig.run("J1,");
  EXPECT_EQ(rig.position(1), 4) << "five programs linked (p.21)";
}

TEST(VxmLoops, AProgramMayJumpToItself) {
  Rig rig = Rig::online();
  rig.send("I1M1,P1,J0,R");
  rig.run_for(1min);
  EXPECT_EQ(rig.ask("V"), "B") << "J opens nothing";
  EXPECT_GT(rig.position(1), 100);
}

TEST(VxmLoops, FourJumpsMayBeOpenTheFifthIsTooMany) {
  Rig rig = Rig::online();
  rig.send("PM1,JM2,PM2,JM3,PM3,JM4,PM4,I1M1,PM0,");
  rig.run("JM1,I1M10,");
  EXPECT_EQ(rig.position(1), 11);
  rig.send("PM4,JM0,PM0,R");
  EXPECT_TRUE(rig.run_until_output("EJ"));
  EXPECT_EQ(rig.output(), "EJ");
  rig.run_for(10s);
  EXPECT_EQ(rig.ask("V"), "");
  EXPECT_EQ(rig.ask("K"), "^");
  EXPECT_EQ(rig.ask("V"), "R");
}

TEST(VxmLoops, WaysBackOfBothMotorsAreMade) {
  Rig rig = Rig::online();
  rig.send("PM1,IA1M0,IA2M0,PM0,");
  rig.run("IA1M100,IA2M50,JM-1,I1M7,");
  EXPECT_EQ(rig.position(1), 107);
  EXPECT_EQ(rig.position(2), 50) << "the other motor is moved back as well (App. S)";
  Rig order = Rig::online();
  order.send("PM1,IA1M0,IA2M0,PM0,");
  EXPECT_TRUE(same_time(order.run("IA1M100,IA2M50,JM-1,I1M7,"), 2 * t(100) + 2 * t(50) + t(50) + t(107)));
}

TEST(VxmLoops, TheWayBackOfSeveralAbsoluteIndexesIsTheirSum) {
  Rig rig = Rig::online();
  rig.send("PM1,IA1M0,IA1M30,PM0,");
  EXPECT_TRUE(same_time(rig.run("IA1M100,JM-1,I1M7,"), t(100) + t(100) + t(30) + t(77)));
  EXPECT_EQ(rig.position(1), 107);
}

TEST(VxmLoops, AnAbsoluteIndexForgetsTheWayBack) {
  Rig rig = Rig::online();
  rig.send("PM1,IA1M0,PM0,");
  rig.run("IA1M100,JM-1,IA1M0,I1M7,");
  EXPECT_EQ(rig.position(1), 7) << "App. S, 3.";
  rig.run("IA1M100,JM-1,IA2M5,I1M7,");
  EXPECT_EQ(rig.position(1), 7) << "of any motor";
}

TEST(VxmLoops, AtTheEndOfTheRunTheWayBackIsForgotten) {
  Rig rig = Rig::online();
  rig.send("PM1,IA1M0,PM0,");
  rig.run("IA1M100,JM-1,");
  EXPECT_EQ(rig.position(1), 0) << "V51";
  rig.run("I1M7,");
  EXPECT_EQ(rig.position(1), 7);
}

TEST(VxmLoops, RelativeIndexesInsideAreNotUndone) {
  Rig rig = Rig::online();
  rig.send("PM1,IA1M0,I1M3,PM0,");
  rig.run("IA1M100,JM-1,I1M7,");
  EXPECT_EQ(rig.position(1), 110) << "V53: 3 stay, 100 back, 7 on";
}

TEST(VxmLoops, ALoopThatTakesNoTimeHangsNothing) {
  for (const char* program :
       {"L0,", "LM0,S1M5,L0,", "J0,", "U5,U4,L0,", "IA1M0,L65535,LA65535,LA65535,L0,"}) {
    Rig rig = Rig::online();
    rig.send(program);
    rig.send("R");
    EXPECT_EQ(rig.ask("V"), "B") << program;
    rig.run_for(10ms);
    EXPECT_EQ(rig.ask("X"), "+0000000\r") << program;
    EXPECT_EQ(rig.ask("K"), "^") << program;
    EXPECT_EQ(rig.ask("V"), "R") << program;
  }
}

}  // namespace hw::vxm::proof
