// Rows of loops and of synchronisation.
#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {

// --- loops -------------------------------------------------------------------------------------------------

VME58_FORM("vme58.loop.LS") {
  Rig rig;
  rig.send("AX LS3 MR100 GO LE ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 300);
  // Four levels on each axis, not five (decision M62).
  rig.send("LS2 LS2 LS2 LS2 MR1 GO ");
  EXPECT_FALSE(rig.command_error());
  rig.send("LS2 ");
  EXPECT_TRUE(rig.command_error());
  rig.send("LE LE LE LE ID ");
  EXPECT_FALSE(rig.command_error());
  rig.send("CA ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 300 + 16);
  rig.send("LS0 ");
  EXPECT_TRUE(rig.command_error());
  // The blocks of one axis are not those of another.
  rig.send("AX LS2 AY LS3 MR10 GO LE AX MR1 GO LE ");
  EXPECT_FALSE(rig.command_error());
  rig.run_until_quiet();
  EXPECT_EQ(rig.position('Y'), 30);
  EXPECT_EQ(rig.position('X'), 318);
}

VME58_FORM("vme58.loop.LE") {
  Rig rig;
  rig.send("AX LE ");
  EXPECT_TRUE(rig.command_error()) << "alone (decision M62)";
  // The innermost block: MR1 four times, MR10 twice. The block keeps its room until it is left.
  rig.send("LS2 LS2 MR1 GO LE MR10 GO LE ");
  EXPECT_LT(rig.room('X'), queue_entries - 10);
  rig.run_until_quiet();
  EXPECT_EQ(rig.position('X'), 24);
  EXPECT_EQ(rig.room('X'), queue_entries);
  rig.send("WH LE ");
  EXPECT_TRUE(rig.command_error()) << "of another kind of block";
}

VME58_FORM("vme58.loop.WS") {
  Rig rig;
  // The input is high, that is false: once all the same, because the test is at the end.
  rig.send("AX WS0 MR100 GO WD ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 100);
  rig.line(0, true);
  rig.send("VL1000 MA0 GO WS0 MR100 GO WD ");
  rig.run_for(1s);
  EXPECT_GT(rig.position('X'), 300) << "on and on while it is low";
  rig.line(0, false);
  rig.run_until_quiet();
  EXPECT_EQ(rig.position('X') % 100, 0);
  EXPECT_EQ(rig.room('X'), queue_entries);
  rig.send("WS14 ");
  EXPECT_TRUE(rig.command_error());
}

VME58_FORM("vme58.loop.WD") {
  Rig rig;
  rig.send("AX WD ");
  EXPECT_TRUE(rig.command_error());
  // Tested here only: what the input does inside the block does not matter.
  rig.line(3, true);
  rig.send("WS3 MR10 GO WT100 WD ");
  rig.run_for(50ms);
  rig.line(3, false);
  rig.run_for(20ms);
  rig.line(3, true);
  rig.run_for(100ms);
  rig.line(3, false);
  rig.run_until_quiet();
  EXPECT_EQ(rig.position('X'), 20);
}

VME58_FORM("vme58.loop.WH") {
  Rig rig;
  rig.send("AX VL1000 WH MR100 GO WG ID ");
  rig.run_for(10s);
  EXPECT_GT(rig.position('X'), 3000);
  EXPECT_EQ(rig.done(), 0);
  rig.send("CW ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X') % 100, 0);
  // A loop in which nothing takes time does not bring the board to a standstill.
  rig.send("AY WH WG ID ");
  rig.run_for(1s);
  EXPECT_EQ(rig.value("WY"), "VME58 ver 2.24-8S");
  rig.send("AY CW ");
  rig.run_for(2ms);
  EXPECT_NE(rig.done() & bit_of('Y'), 0);
}

VME58_FORM("vme58.loop.WG") {
  Rig rig;
  rig.send("AX WG ");
  EXPECT_TRUE(rig.command_error());
  rig.send("AX WT100 WH MR50 GO WG MR1 GO ");
  rig.send("CW ");  // before the block is reached: it runs once (decision M63)
  rig.run_until_quiet();
  EXPECT_EQ(rig.position('X'), 51);
  rig.send("LS2 WG ");
  EXPECT_TRUE(rig.command_error());
}

VME58_FORM("vme58.loop.CW") {
  Rig rig;
  rig.send("AX CW ");
  EXPECT_FALSE(rig.command_error());
  rig.send("VL1000 WH MR100 GO WG AY VL1000 WH MR100 GO WG ");
  rig.run_for(1s);
  rig.send("AX CW ");
  rig.run_for(1s);
  EXPECT_FALSE(rig.moving('X'));
  EXPECT_TRUE(rig.moving('Y')) << "it reaches the addressed axis alone";
  rig.send("AY");
  rig.mail("CW");
  rig.run_for(1s);
  EXPECT_FALSE(rig.moving('Y')) << "through the mailbox too";
}

// --- synchronisation ---------------------------------------------------------------------------------------

VME58_FORM("vme58.sync.ID") {
  Rig rig;
  rig.write8(reg::vector, 99);
  rig.write8(reg::control, 0x90);
  rig.send("AX VL1000 MR1000 GO ID ");
  EXPECT_FALSE(rig.bus().interrupt());
  rig.run_until_done("X");
  EXPECT_EQ(rig.bus().interrupt().value_or(0), 99);
  EXPECT_EQ(rig.done(), bit_of('X'));
  // In AA the flags of all axes of the last move (decision M53).
  rig.send("AA MR10,,10; GO ID ");
  rig.run_until_done("XZ");
  EXPECT_EQ(rig.done(), bit_of('X') | bit_of('Z'));
}

VME58_FORM("vme58.sync.II") {
  Rig rig;
  rig.send("AA VL1000,1000; MR100,100; GO II ID ");
  EXPECT_EQ(rig.done(), 0);
  rig.run_until_quiet();
  EXPECT_EQ(rig.done(), bit_of('X') | bit_of('Y'));
  // In AM each group's, as it ends.
  rig.send("AM MR100; GO II MR,1000; GO II ");
  rig.run_for(500ms);
  EXPECT_EQ(rig.done(), bit_of('X'));
  rig.run_for(2s);
  EXPECT_EQ(rig.done(), bit_of('Y'));
  rig.send("AX MR100 GO II ");
  EXPECT_FALSE(rig.command_error()) << "as ID (decision M55)";
  rig.run_until_quiet();
  EXPECT_EQ(rig.done(), bit_of('X'));
}

VME58_FORM("vme58.sync.IN") {
  Rig rig;
  rig.send("AX VL1000 AC1000000 IN100 MR1000 GO ");
  rig.run_for(890ms);
  EXPECT_EQ(rig.done(), 0);
  rig.run_for(20ms);
  EXPECT_EQ(rig.done(), bit_of('X')) << "early, with 100 counts left (decision M54)";
  rig.run_until_quiet();
  EXPECT_EQ(rig.done(), 0) << "once";
  // Behind GO it is meant for the move under way.
  rig.send("MR1000 GO IN500 ");
  rig.run_for(450ms);
  EXPECT_EQ(rig.done(), 0);
  rig.run_for(100ms);
  EXPECT_EQ(rig.done(), bit_of('X'));
  rig.send("IN-1 ");
  EXPECT_TRUE(rig.command_error());
}

VME58_FORM("vme58.sync.IC") {
  Rig rig = Rig::model("4E");
  rig.send("AX ES10 ID AY ID XX ");
  rig.operate(bench::Jam(AxisId{0}, true));
  rig.send("AX MR1000 GO ");
  rig.run_for(1s);
  rig.send("IC");
  EXPECT_EQ(rig.status(), status::initialized) << "done, slip and command error";
  EXPECT_EQ(rig.done(), 0);
  EXPECT_EQ(rig.read8(reg::slip), 0);
}

VME58_FORM("vme58.sync.CA") {
  Rig rig;
  rig.send("AX ID AY ID AZ ID AY CA ");
  EXPECT_EQ(rig.done(), bit_of('X') | bit_of('Z'));
  rig.send("XX AX CA ");
  EXPECT_TRUE(rig.command_error()) << "the done flag alone";
}

VME58_FORM("vme58.sync.WA") {
  Rig rig;
  rig.send("AX VL1000 MR1000 GO AY VL1000 MR500 GO AA WA ID ");
  rig.run_for(900ms);
  EXPECT_EQ(rig.done(), 0);
  rig.run_for(200ms);
  EXPECT_EQ(rig.done(), 0xFF) << "all axes have finished";
  rig.send("AM WA ");
  EXPECT_TRUE(rig.command_error()) << "outside AA (decision M94)";
}

VME58_FORM("vme58.sync.WQ") {
  Rig rig;
  rig.send("AX VL1000 MR1000 GO WQ RP");
  EXPECT_EQ(rig.output(), "") << "queries wait as well";
  EXPECT_GT(rig.waiting(), 0);
  rig.run_for(2s);
  EXPECT_EQ(rig.output(), framed("1000"));
  rig.send("AY MR1 GO AX WQ RP");
  EXPECT_NE(rig.output(), "") << "the queue of the present mode alone";
}

VME58_FORM("vme58.sync.SW") {
  Rig rig;
  rig.line(0, true);
  rig.send("AX SW0 MR100 GO ID ");
  rig.run_for(10s);
  EXPECT_EQ(rig.position('X'), 0);
  rig.line(0, false);
  EXPECT_TRUE(rig.moving('X') || rig.position('X') > 0 || rig.room('X') < queue_entries);
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 100);
  // An output line of the board itself will do as well.
  rig.send("CA BL8 SW8 ID AY WT50 BH8 ");
  rig.run_for(49ms);
  EXPECT_EQ(rig.done() & bit_of('X'), 0);
  rig.run_for(2ms);
  EXPECT_EQ(rig.done(), bit_of('X'));
}

VME58_FORM("vme58.sync.WT") {
  Rig rig;
  rig.send("AX WT100 ID ");
  rig.run_for(Duration(100ms) - 1ns);
  EXPECT_EQ(rig.done(), 0);
  rig.run_for(1ns);
  EXPECT_EQ(rig.done(), bit_of('X'));
  rig.send("WT0 ID ");
  EXPECT_EQ(rig.done(), bit_of('X'));
  rig.send("WT4294967296 ");
  EXPECT_TRUE(rig.command_error()) << "32 bits (decision M64)";
  rig.send("WT-1 ");
  EXPECT_TRUE(rig.command_error());
  rig.send("WT4294967295 ");
  EXPECT_FALSE(rig.command_error());
}

}  // namespace hw::vme58::proof
