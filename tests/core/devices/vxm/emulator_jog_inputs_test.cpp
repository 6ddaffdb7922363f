// The jog inputs of the I/O connector are the same lines as the buttons of the front panel (VXM manual, App. T).
#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {
namespace {

TEST(VxmJogInputs, AnInputOfTheConnectorJogsAsItsButtonDoes) {
  Rig rig;
  rig.input(6, true);  // 1+
  rig.run_for(50ms);
  rig.input(6, false);
  rig.run_for(1s);
  EXPECT_EQ(rig.load(1), 1);
  rig.input(7, true);  // 2-
  rig.run_for(50ms);
  rig.input(7, false);
  rig.run_for(1s);
  EXPECT_EQ(rig.load(2), -1);
}

TEST(VxmJogInputs, ALineStaysLowUntilButtonAndPinAreBothReleased) {
  Rig rig = Rig::online();
  rig.press("1-");
  rig.input(5, true);
  rig.release("1-");
  rig.run_for(100ms);
  EXPECT_EQ(rig.ask("~")[0] & 1, 0) << "the pin is still low";
  rig.input(5, false);
  rig.run_for(100ms);
  EXPECT_EQ(rig.ask("~")[0] & 1, 1);
}

TEST(VxmJogInputs, TheSlavesInputsFollowThoseOfTheMaster) {
  Rig rig = Rig::online_with_slave();
  rig.send("C,U100,U5,R");
  rig.run_for(1s);
  rig.input(9, true);  // input 1 of the Slave
  EXPECT_TRUE(rig.run_until_output("^", 5s));
}

}  // namespace
}  // namespace hw::vxm::proof
