// What the queues of axes, of AA and of AM have to do with each other, and with stops, limits and the
// mailbox.
#include "tests/core/devices/vme58/rig.h"

namespace hw::vme58::proof {

TEST(Vme58Queues, AnAxisAfterTheOtherInOneText) {
  // The data sheet's move to 10,000 counts from home must wait for the homing: VL and AC are queued (decision
  // M17).
  Rig rig;
  rig.send("AX VL1000 AC10000 MR1000 GO VL5000 AC50000 MA-10000 GO ID ");
  rig.run_for(500ms);
  EXPECT_EQ(rig.velocity('X'), 1000);
  EXPECT_EQ(rig.axis_value('X', AxisValue::maximum_velocity), 1000);
  rig.run_until_done("X");
  EXPECT_EQ(rig.axis_value('X', AxisValue::maximum_velocity), 5000);
  EXPECT_EQ(rig.position('X'), -10'000);
}

TEST(Vme58Queues, EachAxisHasItsOwn) {
  Rig rig;
  rig.send("AX VL1000 MR1000 GO ID AY VL1000 MR500 GO ID AZ ID ");
  EXPECT_EQ(rig.done(), bit_of('Z'));
  rig.run_for(600ms);
  EXPECT_EQ(rig.done(), bit_of('Y'));
  rig.run_for(1s);
  EXPECT_EQ(rig.done(), bit_of('X'));
}

TEST(Vme58Queues, StEmptiesTheAddressedOneAlone) {
  Rig rig;
  rig.send("AX VL1000 AC1000000 MR5000 GO MR1 GO AY VL1000 MR5000 GO ID AX ");
  rig.run_for(1s);
  rig.send("ST ID ");
  rig.run_for(100ms);
  EXPECT_EQ(rig.done(), bit_of('X')) << "the ID behind ST comes when the axis rests";
  EXPECT_NEAR(static_cast<double>(rig.position('X')), 1000, 3);
  EXPECT_TRUE(rig.moving('Y'));
  rig.run_until_done("Y");
  EXPECT_EQ(rig.position('Y'), 5000);
}

TEST(Vme58Queues, AMoveOfAaWaitsForAxesThatAreOnTheirWay) {
  Rig rig;
  rig.send("AX VL1000 MR1000 GO AA MR100,100; GO ID ");
  rig.run_for(900ms);
  EXPECT_EQ(rig.position('Y'), 0);
  rig.run_until_done("XY");
  EXPECT_EQ(rig.position('X'), 1100);
  EXPECT_EQ(rig.position('Y'), 100);
}

TEST(Vme58Queues, ALimitEmptiesWhatDrivesTheAxisAndNothingElse) {
  Rig rig;
  rig.send("AA VL1000,1000; MR5000,5000; GO ID AZ VL1000 MR5000 GO ID ");
  rig.run_for(1s);
  rig.limit('Y', '+', true);
  rig.run_for(10s);
  EXPECT_EQ(rig.done(), bit_of('Z')) << "AA's ID has gone with its queue";
  EXPECT_LT(rig.position('X'), 5000) << "a line without one of its axes would be no line";
  EXPECT_EQ(rig.value("AA RQ"), "200");
  // The axis can go the other way.
  rig.send("AY MR-100 GO ID ");
  rig.run_until_done("Y");
  EXPECT_FALSE(rig.command_error());
}

TEST(Vme58Queues, FlLetsTheAxisRunAndItsQueueIsGone) {
  Rig rig;
  rig.send("AX VL1000 MR5000 GO ID MR1 GO ");
  rig.run_for(1s);
  rig.send("FL");
  EXPECT_EQ(rig.room('X'), queue_entries);
  rig.run_for(10s);
  EXPECT_EQ(rig.velocity('X'), 1000) << "past its target (decision M60)";
  EXPECT_GT(rig.position('X'), 10'000);
  EXPECT_EQ(rig.done(), 0);
  rig.send("ST ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.velocity('X'), 0);
}

TEST(Vme58Queues, GoWithNothingPreparedDoesNothing) {
  Rig rig;
  rig.send("AX GO GD ID AA GO ID ");
  EXPECT_FALSE(rig.command_error());
  EXPECT_EQ(rig.done(), 0xFF);
  rig.run_for(1s);
  EXPECT_EQ(rig.value("AA RP"), "0,0,0,0,0,0,0,0");
  // A move is spent by its GO.
  rig.send("AX CA MR10 GO GO ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 10);
}

TEST(Vme58Queues, AMoveThatIsPreparedIsForgottenWithItsQueue) {
  Rig rig;
  rig.send("AX MR100 ST GO ID ");
  rig.run_for(1s);
  EXPECT_EQ(rig.position('X'), 0);
  rig.send("MA500 MA20 GO ID ");
  rig.run_for(1s);
  EXPECT_EQ(rig.position('X'), 20) << "of two the last";
  rig.send("AA LP0; MR5; MR,7; GO ID ");
  rig.run_for(1s);
  EXPECT_EQ(rig.value("AA RP").substr(0, 4), "5,7,") << "lists add up, axis by axis";
}

TEST(Vme58Queues, AnAmGroupThatIsStoppedDoesNotReportItsEnd) {
  Rig rig;
  rig.send("AM VL1000,1000,1000; MR5000,5000; GO ID MR,,5000; GO ID ");
  rig.run_for(1s);
  rig.send("ST ");
  rig.run_for(2s);
  EXPECT_EQ(rig.done(), 0);
  for (const char letter : {'X', 'Y', 'Z'}) EXPECT_FALSE(rig.moving(letter)) << letter;
}

TEST(Vme58Queues, WaitsOfAmWaitForItsGroup) {
  Rig rig;
  rig.send("AM VL1000; MR500; GO WT100 BL8 ");
  rig.run_for(550ms);
  EXPECT_FALSE(rig.line_low(8));
  rig.run_for(200ms);
  EXPECT_TRUE(rig.line_low(8));
}

TEST(Vme58Queues, ARefusedMoveDoesNotHoldTheQueueUp) {
  Rig rig;
  rig.send("AX LP33500000 MR1 GO ID ");
  EXPECT_TRUE(rig.command_error()) << "beyond the printed range (decision M66)";
  EXPECT_EQ(rig.done(), bit_of('X'));
  EXPECT_EQ(rig.room('X'), queue_entries);
}

TEST(Vme58Queues, AContourWithoutItsEndIsNone) {
  Rig rig;
  rig.send("AA CV1000 CD0,0; MT100,100 AX AA CX ");
  EXPECT_TRUE(rig.command_error());
  rig.send("CD0,0,0; CR1,1,3.14 ");
  EXPECT_TRUE(rig.command_error()) << "arcs are for two axes";
  rig.send("CE CX ");
  EXPECT_TRUE(rig.command_error()) << "and the contour is spoiled";
  rig.send("CD0,0; XY MT100,100; CE CX ");
  EXPECT_TRUE(rig.command_error()) << "as by anything else that was not understood";
  rig.run_for(1s);
  EXPECT_EQ(rig.value("AA RP"), "0,0,0,0,0,0,0,0");
  rig.send("AX CD0; ");
  EXPECT_TRUE(rig.command_error()) << "decision M75";
}

TEST(Vme58Queues, LoopsAreForgottenWithTheirQueue) {
  Rig rig;
  rig.send("AX LS2 LS2 LS2 LS2 MR1 GO KL LS2 MR1 GO LE ID ");
  EXPECT_FALSE(rig.command_error());
  rig.run_until_done("X");
  EXPECT_LE(rig.position('X'), 3);
}

TEST(Vme58Queues, ThousandCommandsOneAfterTheOther) {
  Rig rig;
  rig.send("AX ");
  for (int i = 0; i < 1000; ++i) rig.send("LP" + std::to_string(i) + " ");
  EXPECT_EQ(rig.position('X'), 999);
  EXPECT_FALSE(rig.command_error());
}

}  // namespace hw::vme58::proof
