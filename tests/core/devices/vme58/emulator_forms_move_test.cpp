// Rows of the commands that prepare, start and end moves: move, exec, stop.
#include <cmath>

#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

/// Time of a move from rest to rest that reaches its speed.
double lasts_s(double way, double speed, double rate) { return way / speed + speed / rate; }

constexpr std::string_view slow_x = "AX VL1000 AC10000 ";

}  // namespace

VME58_FORM("vme58.move.AC") {
  Rig rig;
  rig.send("AX VL1000 AC10000 MR1000 GO ID ");
  EXPECT_NEAR(seconds(rig.run_until_done("X")), lasts_s(1000, 1000, 10'000), 1e-5);
  EXPECT_EQ(rig.value("RC"), "10000");
  rig.send("AC8000001 ");
  EXPECT_TRUE(rig.command_error()) << "decision M67";
  EXPECT_EQ(rig.value("RC"), "10000");
  Rig fresh;
  EXPECT_EQ(fresh.value("AX RC"), "2000000") << "decision M47";
  // It waits in the queue: the move before keeps its own rate (decision M17).
  fresh.send("AX VL1000 AC10000 MR1000 GO ID AC50 ");
  EXPECT_NEAR(seconds(fresh.run_until_done("X")), lasts_s(1000, 1000, 10'000), 1e-5);
}

VME58_FORM("vme58.move.AC.list") {
  Rig rig;
  rig.send("AA AC100,,300; ");
  EXPECT_EQ(rig.value("AX RC"), "100");
  EXPECT_EQ(rig.value("AY RC"), "2000000") << "a skipped place stays";
  EXPECT_EQ(rig.value("AZ RC"), "300");
}

VME58_FORM("vme58.move.VL") {
  Rig rig;
  rig.send("AX VL1000 AC10000 JG500 WT1 JG0 MR5000 GO ID ");
  rig.run_for(1s);
  EXPECT_EQ(rig.velocity('X'), 1000);
  rig.run_until_done("X");
  rig.send("VL1044001 ");
  EXPECT_TRUE(rig.command_error());
  EXPECT_EQ(rig.axis_value('X', AxisValue::maximum_velocity), 1000);
  Rig fresh;
  EXPECT_EQ(fresh.axis_value('X', AxisValue::maximum_velocity), 200'000);
}

VME58_FORM("vme58.move.VL.list") {
  Rig rig;
  rig.send("AM VL5000,,700; AX VL60 ");
  EXPECT_EQ(rig.axis_value('X', AxisValue::maximum_velocity), 60);
  EXPECT_EQ(rig.axis_value('Y', AxisValue::maximum_velocity), 200'000);
  EXPECT_EQ(rig.axis_value('Z', AxisValue::maximum_velocity), 700);
}

VME58_FORM("vme58.move.VB") {
  Rig rig;
  rig.send("AX VL1000 AC1000 VB600 MR5000 GO ID ");
  rig.run_for(1ms);
  EXPECT_NEAR(static_cast<double>(rig.velocity('X')), 600, 2) << "begins at that speed";
  rig.run_for(200ms);
  EXPECT_NEAR(static_cast<double>(rig.velocity('X')), 801, 2);
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 5000);
  Rig both;
  both.send("AA VB100,200; AX ");
  EXPECT_EQ(both.axis_value('X', AxisValue::base_velocity), 100);
  EXPECT_EQ(both.axis_value('Y', AxisValue::base_velocity), 200);
  EXPECT_EQ(both.axis_value('Z', AxisValue::base_velocity), 0);
}

VME58_FORM("vme58.move.LP") {
  Rig rig;
  rig.send("AX LP1234 ");
  EXPECT_EQ(rig.position('X'), 1234);
  EXPECT_EQ(rig.value("RE"), "1234") << "both registers (decision M92)";
  EXPECT_EQ(rig.view().load_position[0].value, 0) << "nothing moves";
  rig.send("AA LP,-7,8; ");
  EXPECT_EQ(rig.value("RP"), "1234,-7,8,0,0,0,0,0");
  // While it moves: the target of a relative move shifts along, an absolute one stands.
  rig.send("AX VL1000 AC10000 LP0 MR2000 GO ID AY VL1000 AC10000 LP0 MA2000 GO ID ");
  rig.run_for(1s);
  rig.send("AX LP0 AY LP0 ");
  rig.run_until_done("XY");
  EXPECT_EQ(rig.position('X'), 1050);
  EXPECT_EQ(rig.position('Y'), 2000);
  rig.send("LP33500001 ");
  EXPECT_TRUE(rig.command_error());
}

VME58_FORM("vme58.move.MA") {
  Rig rig;
  rig.send(slow_x);
  rig.send("LP100 MA-900 ");
  rig.run_for(1s);
  EXPECT_EQ(rig.position('X'), 100) << "GO starts it";
  rig.send("GO ID ");
  EXPECT_NEAR(seconds(rig.run_until_done("X")), lasts_s(1000, 1000, 10'000), 1e-5);
  EXPECT_EQ(rig.position('X'), -900);
  EXPECT_EQ(rig.value("QA").substr(0, 1), "M") << "went to minus";
  rig.send("MA33500001 ");
  EXPECT_TRUE(rig.command_error()) << "decision M66";
}

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

VME58_FORM("vme58.move.MR") {
  Rig rig;
  rig.send("AX MR1000 GO MR-300 GO ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 700) << "from where it is when it starts";
  // The sum is beyond the range: only known when it starts.
  rig.send("AX LP33000000 MR600000 GO ID ");
  rig.run_until_quiet();
  EXPECT_TRUE(rig.command_error());
  EXPECT_EQ(rig.position('X'), 33'000'000);
  rig.send("MR67000001 ");
  EXPECT_TRUE(rig.command_error());
}

VME58_FORM("vme58.move.MR.list") {
  Rig rig;
  rig.send("AM LP100,200; MR1000,-500; GO ID ");
  rig.run_until_done("XY");
  EXPECT_EQ(rig.value("AA RP"), "1100,-300,0,0,0,0,0,0");
}

VME58_FORM("vme58.move.MT") {
  Rig rig;
  rig.send("AA VL1000,1000; AC10000,10000; LP500,0; MT1500,2000; ");
  rig.run_for(1s);
  EXPECT_EQ(rig.value("RP"), "500,0,0,0,0,0,0,0") << "decision M49: GO starts it";
  rig.send("GO ID ");
  EXPECT_NEAR(seconds(rig.run_until_done("XY")), lasts_s(2000, 1000, 10'000), 1e-5) << "the longest axis";
  EXPECT_EQ(rig.value("AA RP"), "1500,2000,0,0,0,0,0,0");
  rig.send("AX MT5 ");
  EXPECT_TRUE(rig.command_error()) << "not for one axis";
}

VME58_FORM("vme58.move.ML") {
  Rig rig;
  rig.send("AA LP100,100,100,100,100,100,100,100; ML8,7,6,5,4,3,2,-1; GO ID ");
  rig.run_until_done("XYZTUVRS");
  EXPECT_EQ(rig.value("AA RP"), "108,107,106,105,104,103,102,99");
}

VME58_FORM("vme58.move.RM") {
  Rig rig;
  rig.send("AX LP1234 RM400 ");
  EXPECT_EQ(rig.position('X'), 34);
  EXPECT_EQ(rig.value("RE"), "34");
  rig.send("LP-1234 RM400 ");
  EXPECT_EQ(rig.position('X'), -34) << "decision M65";
  rig.send("RM0 ");
  EXPECT_TRUE(rig.command_error());
  // In the queue: behind the move.
  rig.send("LP0 MA900 GO RM400 ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 100);
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

VME58_FORM("vme58.exec.GD") {
  Rig rig;
  rig.send("AX ID AY ID AX VL1000 MR500 GD ");
  EXPECT_EQ(rig.done(), 2) << "the flag of X is gone, that of Y stays (decision M52)";
  rig.send("ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 500);
}

VME58_FORM("vme58.exec.JG") {
  Rig rig;
  rig.send("AX AC10000 JG1000 ");
  rig.run_for(2s);
  EXPECT_EQ(rig.velocity('X'), 1000);
  EXPECT_EQ(rig.position('X'), 1950);
  rig.send("JG250 ");
  rig.run_for(1s);
  EXPECT_EQ(rig.velocity('X'), 250) << "on the move";
  rig.send("JG-500 ");
  rig.run_for(1s);
  EXPECT_EQ(rig.velocity('X'), 500);
  EXPECT_EQ(rig.value("QA").substr(0, 1), "M");
  rig.send("MA0 GO ");
  rig.run_for(10s);
  EXPECT_EQ(rig.velocity('X'), 500) << "a move does not end it (decision M61)";
  EXPECT_TRUE(rig.command_error());
  rig.send("JG0 ");
  rig.run_for(1s);
  EXPECT_EQ(rig.velocity('X'), 0);
  rig.send("JG1044001 ");
  EXPECT_TRUE(rig.command_error());
  Rig both;
  both.send("AA JG100,-200; ");
  both.run_for(10s);
  EXPECT_NEAR(static_cast<double>(both.position('X')), 1000, 1);
  EXPECT_NEAR(static_cast<double>(both.position('Y')), -2000, 1);
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

VME58_FORM("vme58.exec.FL") {
  Rig rig;
  rig.send("AX VL1000 AC1000 MR5000 GO BL8 ");
  rig.run_for(500ms);
  rig.send("FL ");
  EXPECT_EQ(rig.room('X'), 200);
  rig.run_for(100s);
  EXPECT_EQ(rig.velocity('X'), 500) << "goes on as it was (decision M60)";
  EXPECT_GT(rig.position('X'), 5000);
  EXPECT_FALSE(rig.line_low(8)) << "what stood behind the move is forgotten";
  rig.send("ST ");
  rig.run_for(1s);
  EXPECT_EQ(rig.velocity('X'), 0);
}

// --- stop --------------------------------------------------------------------------------------------------

VME58_FORM("vme58.stop.ST") {
  Rig rig;
  rig.send("AX VL1000 AC1000 MR8000 GO BL8 AY VL1000 AC1000 MR8000 GO ID ");
  rig.run_for(2s);
  rig.send("AX ST ");
  EXPECT_EQ(rig.room('X'), 200);
  rig.run_for(2s);
  EXPECT_EQ(rig.position('X'), 2000) << "1500, and the ramp of AC";
  EXPECT_FALSE(rig.line_low(8));
  EXPECT_EQ(rig.velocity('Y'), 1000) << "the addressed axis only";
  rig.run_until_done("Y");
  EXPECT_EQ(rig.position('Y'), 8000);
  // In AA: all axes of its move, on their line.
  Rig all;
  all.send("AA VL1000,1000; AC1000,1000; MT8000,4000; GO ");
  all.run_for(2s);
  all.send("ST ");
  all.run_until_quiet();
  EXPECT_EQ(all.value("AA RP"), "2000,1000,0,0,0,0,0,0");
}

VME58_FORM("vme58.stop.SA") {
  Rig rig;
  rig.send("AX AC1000 VL1000 MR8000 GO AY AC1000 JG-1000 AA ");
  rig.run_for(2s);
  rig.send("SA ");
  EXPECT_EQ(rig.room('X'), 200);
  rig.run_until_quiet();
  EXPECT_EQ(rig.position('X'), 2000);
  EXPECT_EQ(rig.position('Y'), -2000);
}

VME58_FORM("vme58.stop.SD") {
  Rig rig;
  rig.send("AY ID AX AC1000 JG1000 ");
  rig.run_for(2s);
  rig.send("SD ");
  EXPECT_EQ(rig.done(), 0) << "flags cleared";
  rig.run_until_quiet();
  EXPECT_EQ(rig.position('X'), 2000) << "as SA (decision M57)";
}

VME58_FORM("vme58.stop.KL") {
  Rig rig;
  rig.send("AX AC1000 VL1000 MR8000 GO BL8 AY AC1000 JG-1000 ");
  rig.run_for(2s);
  rig.send("KL ");
  EXPECT_EQ(rig.velocity('X'), 0);
  EXPECT_EQ(rig.velocity('Y'), 0);
  EXPECT_EQ(rig.room('X'), 200);
  rig.run_until_quiet();
  EXPECT_EQ(rig.position('X'), 1500) << "no ramp";
  EXPECT_EQ(rig.position('Y'), -1500);
  EXPECT_FALSE(rig.line_low(8));
}

}  // namespace hw::vme58::proof
