// Rows of the contours.
// Those that neither loop nor compute stand in vme58.forms.
#include <cmath>
#include <numbers>

#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

/// AA in force, gentle ramps.
Rig contouring() {
  Rig rig;
  rig.send("AA AC10000,10000,10000,10000; CV1000 ");
  return rig;
}

double from_centre(Rig& rig, char first, char second) {
  return std::hypot(static_cast<double>(rig.position(first)), static_cast<double>(rig.position(second)));
}

}  // namespace

VME58_FORM("vme58.contour.CR") {
  Rig rig = contouring();
  rig.send("CD1000,0; CR0,0,3.1415926535898 CK LP1000,0; CX ");
  rig.run_for(1571ms);
  EXPECT_NEAR(static_cast<double>(rig.position('X')), 0, 2) << "counter-clockwise (decision M70)";
  EXPECT_NEAR(static_cast<double>(rig.position('Y')), 1000, 1);
  EXPECT_NEAR(from_centre(rig, 'X', 'Y'), 1000, 1);
  rig.run_until_quiet();
  EXPECT_EQ(rig.value("AA RP"), "-1000,0,0,0,0,0,0,0");
  rig.send("CD-1000,0; CR0,0,-1.5707963267949 CK CX ");
  rig.run_until_quiet();
  EXPECT_EQ(rig.value("AA RP"), "0,1000,0,0,0,0,0,0") << "a negative angle turns clockwise";
  rig.send("CD0,0,0; CR0,0,1 ");
  EXPECT_TRUE(rig.command_error()) << "two axes only";
  rig.send("CE CX ");
  EXPECT_TRUE(rig.command_error()) << "a contour with a fault is not played";
  rig.send("CD0,0; CR0,5,1e ");
  rig.send("CE CD0,0; CR0,5,99999999999999999999 CE CX ");
  EXPECT_TRUE(rig.command_error()) << "without end";
  EXPECT_FALSE(rig.moving('X'));
}

VME58_FORM("vme58.contour.CK") {
  Rig rig = contouring();
  const Duration begin = rig.elapsed();
  rig.send("CD0; MT1000 CK CX ");
  rig.run_for(999ms);
  EXPECT_EQ(rig.velocity('X'), 1000);
  rig.run_until_quiet();
  EXPECT_EQ(rig.position('X'), 1000);
  EXPECT_NEAR(seconds(rig.elapsed() - begin), 1, 1e-4);
}

VME58_FORM("vme58.contour.CV") {
  Rig rig = contouring();
  rig.send("CV200 CD0,0; MT3000,4000 CK CX ");
  rig.run_for(10s);
  EXPECT_NEAR(std::hypot(static_cast<double>(rig.velocity('X')), static_cast<double>(rig.velocity('Y'))), 200,
              1.5);
  Rig fresh;
  fresh.send("AA CD0; MT1000 CK CX ");
  EXPECT_TRUE(fresh.command_error()) << "needed before CX (decision M71)";
  fresh.send("CV1044001 ");
  EXPECT_TRUE(fresh.command_error());
}

}  // namespace hw::vme58::proof
