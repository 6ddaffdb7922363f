// Rows of user inputs and outputs.
// Those that neither loop nor compute stand in vme58.forms.
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

}  // namespace hw::vme58::proof
