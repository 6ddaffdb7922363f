// Rows of user inputs and outputs.
#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {

VME58_FORM("vme58.io.AN") {
  Rig rig;
  rig.send("AY AF AN ");
  EXPECT_TRUE(rig.aux_high('Y'));
  rig.send("AF WT100 AN ");
  EXPECT_FALSE(rig.aux_high('Y')) << "it waits in the queue";
  rig.run_for(100ms);
  EXPECT_TRUE(rig.aux_high('Y'));
  rig.send("AA AF AN ");
  for (const char letter : axis_letters) EXPECT_TRUE(rig.aux_high(letter)) << letter;
}

VME58_FORM("vme58.io.AF") {
  Rig rig;
  for (const char letter : axis_letters)
    EXPECT_TRUE(rig.aux_high(letter)) << "high at power-up (decision M37)";
  rig.send("AT AF ");
  for (const char letter : axis_letters) EXPECT_EQ(rig.aux_high(letter), letter != 'T');
  rig.send("AA AF ");
  for (const char letter : axis_letters) EXPECT_FALSE(rig.aux_high(letter));
}

VME58_FORM("vme58.io.PA") {
  Rig rig;
  rig.send("AX PA1 AF VL1000 MR1000 GO ");
  EXPECT_TRUE(rig.aux_high('X')) << "high with the begin of the move";
  rig.run_for(500ms);
  EXPECT_TRUE(rig.aux_high('X'));
  rig.run_for(1s);
  EXPECT_FALSE(rig.aux_high('X')) << "low after it";
  rig.send("PA0 MR1000 GO ");
  rig.run_for(500ms);
  EXPECT_FALSE(rig.aux_high('X')) << "0 ends it (decision M38)";
  rig.send("PA2 ");
  EXPECT_TRUE(rig.command_error());
}

VME58_FORM("vme58.io.SE") {
  Rig rig;
  rig.send("AX PA1 SE50 VL100000 AC8000000 MR100 GO ID ");
  rig.run_until_done("X");
  EXPECT_TRUE(rig.aux_high('X'));
  rig.run_for(49ms);
  EXPECT_TRUE(rig.aux_high('X'));
  rig.run_for(1ms);
  EXPECT_FALSE(rig.aux_high('X')) << "50 ms after the move";
  // A move within the settling time keeps the power on.
  rig.send("CA MR100 GO ID ");
  rig.run_until_done("X");
  rig.run_for(30ms);
  rig.send("CA MR100 GO ID ");
  rig.run_until_done("X");
  rig.run_for(30ms);
  EXPECT_TRUE(rig.aux_high('X'));
  rig.run_for(20ms);
  EXPECT_FALSE(rig.aux_high('X'));
}

VME58_FORM("vme58.io.BL") {
  Rig rig;
  rig.send("AX BL8 ");
  EXPECT_TRUE(rig.line_low(8));
  EXPECT_EQ(rig.read8(reg::io_high), 0x3E);
  rig.send("WT100 BL9 ");
  EXPECT_FALSE(rig.line_low(9)) << "queued";
  rig.run_for(100ms);
  EXPECT_TRUE(rig.line_low(9));
  rig.send("BL7 ");
  EXPECT_TRUE(rig.command_error()) << "an input by the factory's jumpers (decision M35)";
  rig.send("BL14 ");
  EXPECT_TRUE(rig.command_error());
  // Other jumpers, other outputs; 12 and 13 are always.
  Rig jumpered(DeviceOptions{{"jumpers", "OII"}});
  jumpered.send("BL0 BL3 BL12 ");
  EXPECT_FALSE(jumpered.command_error());
  EXPECT_EQ(jumpered.value("BX"), "2FF6");
  jumpered.send("BL8 ");
  EXPECT_TRUE(jumpered.command_error());
}

VME58_FORM("vme58.io.BH") {
  Rig rig;
  EXPECT_FALSE(rig.line_low(8)) << "high, that is off, at power-up";
  rig.send("AX BL8 BL10 BH8 ");
  EXPECT_FALSE(rig.line_low(8));
  EXPECT_TRUE(rig.line_low(10));
  rig.send("BH0 ");
  EXPECT_TRUE(rig.command_error());
}

VME58_FORM("vme58.io.BX") {
  Rig rig;
  EXPECT_EQ(visible(rig.ask("BX")), "<lf><cr>3FFF<lf><cr>");
  rig.line(0, true);
  rig.send("AX BL13 ");
  EXPECT_EQ(rig.value("BX"), "1FFE") << "1 is high (decision M06)";
  rig.line(7, true);
  EXPECT_EQ(rig.value("BX"), "1F7E");
}

VME58_FORM("vme58.io.RB") {
  Rig rig;
  EXPECT_EQ(visible(rig.ask("RB")), "<lf><cr>3F00<lf><cr>");
  rig.send("AX BL9 ");
  EXPECT_EQ(rig.value("RB"), "3F00") << "directions, not levels";
  EXPECT_EQ(Rig(DeviceOptions{{"jumpers", "IOI"}}).value("RB"), "30F0");
  EXPECT_EQ(Rig(DeviceOptions{{"jumpers", "OOO"}}).value("RB"), "3FFF");
}

}  // namespace hw::vme58::proof
