// Rows of homing, of the staircase and of tracking.
#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

constexpr AxisId first_axis{0};

/// X at 1000 counts/s, its home switch from 2000 to 2400 and from -2400 to -2000 in turn.
Rig stage_with_home(bool behind = false) {
  Rig rig;
  AxisPlace place;
  place.home_from = Steps(behind ? -2400 : 2000), place.home_to = Steps(behind ? -2000 : 2400);
  place.minus = Steps(-9000), place.plus = Steps(9000);
  rig.place('X', place);
  rig.send("AX VL1000 AC10000 ");
  return rig;
}

std::int64_t load_of_x(const Rig& rig) { return rig.view().load_position[0].value; }

}  // namespace

VME58_FORM("vme58.home.HM") {
  Rig rig = stage_with_home();
  rig.send("HM100 ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 150) << "the edge is 100, the ramp goes on for 50 (decision M40)";
  EXPECT_EQ(rig.value("RE"), "150");
  EXPECT_EQ(load_of_x(rig), 2050);
  EXPECT_EQ(rig.value("QA"), "PDNH");
  rig.send("MA100 GD ID ");
  rig.run_until_done("X");
  EXPECT_EQ(load_of_x(rig), 2000);
  // Nothing there: the limit ends it, the counter is not touched.
  rig.send("MA1000 GO HM0 ID ");
  rig.run_until_quiet();
  EXPECT_EQ(load_of_x(rig), 9000);
  EXPECT_EQ(rig.position('X'), 7100);
  EXPECT_EQ(rig.read8(reg::limit) & 1, 1);
}

VME58_FORM("vme58.home.HR") {
  Rig rig = stage_with_home(true);
  rig.send("HR0 ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), -50);
  EXPECT_EQ(load_of_x(rig), -2050);
  Rig both;
  both.home_switch('X', true);
  both.home_switch('Y', true);
  both.send("AA HR7,8; ID ");
  both.run_until_quiet();
  EXPECT_EQ(both.value("RP"), "7,8,0,0,0,0,0,0") << "active already: found where they stand";
}

VME58_FORM("vme58.home.KM") {
  Rig rig = stage_with_home();
  rig.send("LP5 KM ID ");
  rig.run_until_done("X");
  EXPECT_EQ(load_of_x(rig), 2000) << "dead at the edge";
  EXPECT_EQ(rig.position('X'), 2005) << "the counter is not touched (decision M41)";
}

VME58_FORM("vme58.home.KR") {
  Rig rig = stage_with_home(true);
  rig.send("KR ID ");
  rig.run_until_done("X");
  EXPECT_EQ(load_of_x(rig), -2000);
  EXPECT_EQ(rig.position('X'), -2000);
  // With the encoder: the first index mark within the switch.
  Rig index = stage_with_home(true);
  AxisPlace marks;
  marks.index_every = Steps(150);
  index.place('X', marks);
  index.send("HE KR ID ");
  index.run_until_done("X");
  EXPECT_EQ(load_of_x(index), -2100);
}

// --- staircase ---------------------------------------------------------------------------------------------

VME58_FORM("vme58.stair.MP") {
  Rig rig;
  rig.send("AX MP MV-100,1000 ");
  EXPECT_TRUE(rig.command_error()) << "against the direction (decision M84)";
  rig.send("MV100,1000 ");
  EXPECT_FALSE(rig.command_error());
  rig.run_for(1s);
  EXPECT_GT(rig.position('X'), 100);
}

VME58_FORM("vme58.stair.MM") {
  Rig rig;
  rig.send("AX MM ");
  EXPECT_EQ(rig.value("QA").substr(0, 1), "M");
  rig.send("MV100,1000 ");
  EXPECT_TRUE(rig.command_error());
  rig.send("MV-100,1000 SP-5000 ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), -5000);
}

VME58_FORM("vme58.stair.MV") {
  Rig rig;
  rig.send("AX AC100000 MP MV10000,2000 MV20000,5000 BL8 ");
  rig.run_for(3s);
  EXPECT_EQ(rig.velocity('X'), 2000);
  EXPECT_FALSE(rig.line_low(8));
  rig.run_for(3s);
  EXPECT_EQ(rig.velocity('X'), 5000) << "from 10000 on";
  rig.run_for(3s);
  EXPECT_TRUE(rig.line_low(8)) << "passed 20000";
  EXPECT_EQ(rig.velocity('X'), 5000) << "runs on";
  rig.send("MV10,1044001 ");
  EXPECT_TRUE(rig.command_error());
}

VME58_FORM("vme58.stair.SP") {
  // The whole staircase, up and down, to rest exactly there.
  Rig rig;
  rig.send("AX AC100000 MP MV10000,2000 MV20000,5000 MV25000,1000 SP30000 ID ");
  EXPECT_EQ(rig.room('X'), 200 - 3 * 3 - 2 - 1) << "the first MV stays in the queue until it is there";
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 30'000);
  EXPECT_EQ(rig.velocity('X'), 0);
  rig.send("IC JG1000 ");
  rig.run_for(1s);
  rig.send("SP0 ID ");
  EXPECT_FALSE(rig.command_error()) << "behind it: there and back";
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 0);
  rig.send("IC JG500 SP1000 ID ");
  EXPECT_EQ(rig.run_until_done("X"), 2005ms) << "at the speed of the jog";
  EXPECT_EQ(rig.position('X'), 1000);
}

VME58_FORM("vme58.stair.FP") {
  Rig rig;
  rig.send("AX AC1000 MP MV10000,1000 MV20000,2000 SP30000 ");
  rig.run_for(2s);
  rig.send("FP4000 ");
  EXPECT_EQ(rig.room('X'), 200);
  rig.run_until_quiet();
  EXPECT_EQ(rig.position('X'), 4000);
  rig.send("JG1000 ");
  rig.run_for(2s);
  rig.send("FP5600 ");
  rig.run_until_quiet();
  EXPECT_EQ(rig.position('X'), 6000) << "as near as the ramp allows, and not back";
}

// --- tracking ----------------------------------------------------------------------------------------------

VME58_FORM("vme58.enc.ET") {
  Rig rig = Rig::model("4E");
  rig.send("AX ET ");
  rig.operate(bench::Slip(first_axis, Steps(300)));
  EXPECT_EQ(rig.position('X'), 300) << "count for count (decision M81)";
  EXPECT_EQ(rig.value("RE"), "300");
  EXPECT_EQ(load_of_x(rig), 300);
  rig.operate(bench::Slip(first_axis, Steps(-100)));
  EXPECT_EQ(rig.position('X'), 200);
  rig.send("HF ");
  rig.operate(bench::Slip(first_axis, Steps(50)));
  EXPECT_EQ(rig.position('X'), 200) << "HF ends it";
}

}  // namespace hw::vme58::proof
