// Forms of motors, looping and branching that compute (p.16 to 21; App. S); the others: vxm.forms. What is
// left out on a last pass: V37, V38.
#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {

VXM_FORM("vxm.index.home.pos") {
  Rig rig = Rig::online();
  AxisPlace travel;
  travel.plus = Steps(1000);
  rig.place(1, travel);
  EXPECT_TRUE(same_time(rig.run("I1M0,"), 1s)) << "1000 steps of ramp at 2000 steps/s2, stopped hard";
  EXPECT_EQ(rig.position(1), 1000);
  EXPECT_TRUE(same_time(rig.run_program(), 0s)) << "switch already active: no motion (V63)";
  EXPECT_EQ(rig.position(1), 1000);

  Rig endless = Rig::online();
  const Duration took = endless.run("S1M6000,I1M0,");
  EXPECT_NEAR(seconds(took), 16e6 / 6000, 10) << "gives up (V63)";
  EXPECT_EQ(endless.load(1), 16'000'000);
}

VXM_FORM("vxm.loop.forever") {
  Rig rig = Rig::online();
  rig.send("I1M100,P1,L0,I2M9,R");
  const Duration pass = index_time(100) + 100ms;
  rig.run_for(pass * 25 - 1ms);
  EXPECT_EQ(rig.position(1), 2500);
  EXPECT_EQ(rig.ask("V"), "B");
  rig.run_for(pass * 75);
  EXPECT_EQ(rig.position(1), 10000);
  EXPECT_EQ(rig.ask("K"), "^");
  EXPECT_EQ(rig.position(2), 0) << "what stands behind is never reached";
}

VXM_FORM("vxm.loop.reverse2") {
  Rig rig = Rig::online();
  EXPECT_TRUE(
      same_time(rig.run("I1M10,I2M20,LM-2,I2M3,"), 2 * (index_time(10) + index_time(20)) + index_time(3)));
  EXPECT_EQ(rig.position(1), 20) << "motor 1 is not mirrored";
  EXPECT_EQ(rig.position(2), 3) << "once back, nothing left out, then unreversed (V43)";
  expect_dropped(rig, "LM-1");
  expect_dropped(rig, "LM-4");
  expect_dropped(rig, "LM1");
}

VXM_FORM("vxm.jump.pick") {
  Rig rig = Rig::online();
  rig.send("PM1,IA1M0,PM0,");
  const Duration took = rig.run("IA1M1000,JM-1,I1M800,");
  EXPECT_EQ(rig.position(1), 1800) << "back by 1000 and on by 800";
  EXPECT_TRUE(same_time(took, index_time(1000) * 2 + index_time(1800))) << "as one move (V50)";
  expect_dropped(rig, "JM-5");
}

}  // namespace hw::vxm::proof
