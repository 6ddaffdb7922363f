// Rows of the commands that prepare, start and end moves: move, exec, stop.
// Those that neither loop nor compute stand in vme58.forms.
#include <cmath>

#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

/// Time of a move from rest to rest that reaches its speed.
double lasts_s(double way, double speed, double rate) { return way / speed + speed / rate; }

}  // namespace

VME58_FORM("vme58.move.MA.list") {
  // The second example of the data sheet: a straight line in space, all there at once.
  Rig rig;
  rig.send("AA VL5000,5000,5000; AC50000,50000,50000; MA1000,2000,3000; GO ID ");
  rig.run_for(300ms);
  const double x = static_cast<double>(rig.position('X'));
  EXPECT_NEAR(static_cast<double>(rig.position('Y')), 2 * x, 3);
  EXPECT_NEAR(static_cast<double>(rig.position('Z')), 3 * x, 3);
  EXPECT_NEAR(seconds(rig.run_until_done("XYZ")), lasts_s(3000, 5000, 50'000) - 0.3, 1e-5);
  EXPECT_EQ(rig.value("AA RP"), "1000,2000,3000,0,0,0,0,0");
  rig.send("MA,0; GO ");
  rig.run_until_quiet();
  EXPECT_EQ(rig.value("RP"), "1000,0,3000,0,0,0,0,0") << "a skipped axis stays";
}

// --- start -------------------------------------------------------------------------------------------------

VME58_FORM("vme58.exec.GO") {
  Rig rig;
  rig.send("AX GO ID ");
  EXPECT_EQ(rig.done(), 1) << "nothing prepared: nothing happens (decision M51)";
  EXPECT_FALSE(rig.command_error());
  rig.send("CA MR100 GO ID ");
  EXPECT_TRUE(rig.moving('X') || rig.room('X') < 200);
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 100);
  rig.send("GO ID ");
  rig.run_until_quiet();
  EXPECT_EQ(rig.position('X'), 100) << "a move is started once";
}

VME58_FORM("vme58.exec.JF") {
  Rig rig;
  rig.send("AX JF0.25 ");
  rig.run_for(39s);
  EXPECT_EQ(rig.position('X'), 9);
  rig.run_for(2s);
  EXPECT_EQ(rig.position('X'), 10);
  rig.send("JF-0.5 ");
  rig.run_for(41s);
  EXPECT_NEAR(static_cast<double>(rig.position('X')), -10, 1);
  rig.send("ST ");
  const std::int64_t rest = rig.position('X');
  rig.run_for(100s);
  EXPECT_EQ(rig.position('X'), rest);
}

}  // namespace hw::vme58::proof
