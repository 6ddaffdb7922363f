// Rows of homing, of the staircase and of tracking.
// Those that neither loop nor compute stand in vme58.forms.
#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

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

}  // namespace hw::vme58::proof
