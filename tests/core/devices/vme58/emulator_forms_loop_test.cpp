// Rows of loops and of synchronisation.
// Those that neither loop nor compute stand in vme58.forms.
#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {

// --- loops -------------------------------------------------------------------------------------------------

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
