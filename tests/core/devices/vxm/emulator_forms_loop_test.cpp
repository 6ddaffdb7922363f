// Looping and branching commands (p.20, 21; App. S). What is left out on a last pass: V37, V38.
#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {
namespace {

void expect_count_range(const std::string& head, const std::vector<std::string>& refused) {
  Rig rig = Rig::online();
  rig.send(head + "2,");
  EXPECT_EQ(rig.used_bytes(), 3);
  rig.send(head + "65535,");
  EXPECT_EQ(rig.used_bytes(), 6);
  for (const std::string& value : refused) expect_dropped(rig, head + value);
}

}  // namespace

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

VXM_FORM("vxm.loop.marker.set") {
  Rig rig = Rig::online();
  rig.run("I1M100,LM0,I2M10,LA3,");
  EXPECT_EQ(rig.position(1), 100);
  EXPECT_EQ(rig.position(2), 30);
}

VXM_FORM("vxm.loop.marker.reset") {
  Rig rig = Rig::online();
  rig.run("I1M100,LM0,I2M10,LM-0,LA3,");
  EXPECT_EQ(rig.position(1), 300);
  EXPECT_EQ(rig.position(2), 30);
}

VXM_FORM("vxm.loop.count") {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("I2M10,I1M400,L10,"), 10 * index_time(10) + 9 * index_time(400)));
  EXPECT_EQ(rig.position(2), 100);
  EXPECT_EQ(rig.position(1), 3600) << "left out on the last pass";
  expect_count_range("L", {"1", "65536", ""});
}

VXM_FORM("vxm.loop.alternate") {
  Rig rig = Rig::online();
  EXPECT_TRUE(
      same_time(rig.run("I1M100,I2M7,L-4,I1M5,"), 4 * index_time(100) + 3 * index_time(7) + index_time(5)));
  EXPECT_EQ(rig.position(1), 5) << "+ - + -, and the next command unreversed (V41)";
  EXPECT_EQ(rig.position(2), 21) << "motor 2 keeps its direction";
  Rig odd = Rig::online();
  odd.run("I1M100,I2M7,L-3,I1M5,");
  EXPECT_EQ(odd.position(1), 105);
  expect_count_range("L-", {"1", "65536", "", "0"});
}

VXM_FORM("vxm.loop.always.count") {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("I1M10,LA100,"), 100 * index_time(10), 50us));
  EXPECT_EQ(rig.position(1), 1000) << "nothing left out";
  expect_count_range("LA", {"0", "1", "65536", ""});
}

VXM_FORM("vxm.loop.always.alternate") {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("I1M10,LA-100,I1M3,"), 100 * index_time(10) + index_time(3), 50us));
  EXPECT_EQ(rig.position(1), 3);
  Rig odd = Rig::online();
  odd.run("I1M10,LA-3,I1M3,");
  EXPECT_EQ(odd.position(1), 13) << "+ - +, then unreversed";
  expect_count_range("LA-", {"0", "1", "65536", ""});
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

VXM_FORM("vxm.loop.reverse12") {
  Rig rig = Rig::online();
  rig.run("I1M10,I2M20,LM-3,I1M4,I2M3,");
  EXPECT_EQ(rig.position(1), 4);
  EXPECT_EQ(rig.position(2), 3);
}

VXM_FORM("vxm.jump") {
  Rig rig = Rig::online();
  rig.send("PM1,I1M7,PM0,");
  EXPECT_TRUE(same_time(rig.run("J1,I1M1000,"), index_time(7)));
  EXPECT_EQ(rig.position(1), 7) << "without coming back";
  EXPECT_EQ(rig.ask("PM,"), "0\r") << "the selected program stays (V49)";
  EXPECT_TRUE(same_time(rig.run("J3,I1M1000,"), 0s)) << "an empty target ends the run";
  rig.send("C");
  expect_dropped(rig, "J5");
  expect_dropped(rig, "J-1");
}

VXM_FORM("vxm.jump.return") {
  Rig rig = Rig::online();
  rig.send("PM3,I2M7,PM0,");
  rig.run("JM3,I1M1000,JM3,JM4,I1M1,");
  EXPECT_EQ(rig.position(1), 1001) << "an empty target returns at once";
  EXPECT_EQ(rig.position(2), 14);
  EXPECT_EQ(rig.ask("PM,"), "0\r");
  expect_dropped(rig, "JM5");
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
