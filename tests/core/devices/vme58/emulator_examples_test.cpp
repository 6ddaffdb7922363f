// The three programming examples of the data sheet, from their text.
#include <cmath>
#include <numbers>

#include "tests/core/devices/vme58/rig.h"

namespace hw::vme58::proof {
namespace {

TEST(Vme58Examples, HomeThenAMove) {
  Rig rig;
  AxisPlace place;
  place.home_from = Steps(3000), place.home_to = Steps(3500);
  rig.place('X', place);
  rig.send(
      "AX\n"
      "VL1000 AC10000\n"
      "KP2 KD6 HN\n"
      "HM0\n"
      "VL5000 AC50000\n"
      "MA-10000 GO ID\n");
  const Duration took = rig.run_until_done("X");
  EXPECT_FALSE(rig.command_error());
  EXPECT_EQ(rig.position('X'), -10'000);
  EXPECT_EQ(rig.view().load_position[0].value, -7000) << "from the edge of home";
  // 3000 counts at 1000/s, a ramp of 0.1 s at either end; then 10050 at 5000/s.
  EXPECT_NEAR(seconds(took), 3.05 + 0.1 + 10'050 / 5000.0 + 0.1, 1e-4);
}

TEST(Vme58Examples, HomeThenAMoveWithAMotor) {
  Rig rig;
  AxisPlace place;
  place.home_from = Steps(3000), place.home_to = Steps(3500), place.motor = Motor();
  rig.place('X', place);
  rig.send("AX\nVL1000 AC10000\nKP2 KD6 HN\nHM0\nVL5000 AC50000\nMA-10000 GO ID\n");
  rig.run_until_done("X");
  rig.run_for(1s);
  EXPECT_EQ(rig.position('X'), -10'000);
  EXPECT_NEAR(std::atof(rig.value("AX RE").c_str()), -10'000, 2);
  EXPECT_NEAR(static_cast<double>(rig.view().load_position[0].value), -7000, 4);
}

TEST(Vme58Examples, ThreeAxesInSpace) {
  Rig rig;
  rig.send(
      "AX KP2 KD6 HN\n"
      "AY KP2 KD6 HN\n"
      "AZ KP2 KD6 HN\n"
      "AM\n"
      "VL5000,5000,5000;\n"
      "AC50000,50000,50000;\n"
      "MA1000,2000,3000; GO ID\n");
  rig.run_for(350ms);
  const auto x = static_cast<double>(rig.position('X'));
  EXPECT_NEAR(x, 500, 1);
  EXPECT_NEAR(static_cast<double>(rig.position('Z')), 3 * x, 2);
  const Duration took = rig.run_until_done("XYZ");
  EXPECT_NEAR(seconds(took), 0.35, 1e-4) << "3000 counts at 5000/s and 0.1 s of ramp in all";
  EXPECT_FALSE(rig.command_error());
  EXPECT_EQ(rig.value("AA RP"), "1000,2000,3000,0,0,0,0,0");
}

TEST(Vme58Examples, AHoleIsCut) {
  Rig rig;
  rig.send("AX AF ");  // the torch is off
  rig.send("AA\n");    // the sheet names no mode (decision M75)
  rig.send("AC,,10000,10000;");
  rig.send(
      "CV1000\n"
      "CD,,0,0;\n"
      "AN0;\n"
      "CR0,5000,3.1415926\n"
      "CR0,0,6.2831853\n"
      "AF0;\n"
      "MT-10,10000\n"
      "CE\n"
      "MT,,-1000,0; GO\n"
      "CX\n");
  EXPECT_FALSE(rig.command_error());
  bool was_on = false;
  double on_s = 0, off_s = 0;
  int outside = 0, samples = 0;
  while (rig.emulator().next_event() && off_s == 0) {
    rig.run_for(7ms);
    const bool on = rig.aux_high('X');
    const auto z = static_cast<double>(rig.position('Z')), t = static_cast<double>(rig.position('T'));
    if (on && !was_on) {
      on_s = seconds(rig.elapsed());
      EXPECT_NEAR(std::hypot(z, t), 0, 8) << "begins at the centre";
    }
    if (!on && was_on) off_s = seconds(rig.elapsed());
    was_on = on;
    if (!on) continue;
    ++samples;
    const double half = std::abs(std::hypot(z, t - 5000) - 5000), whole = std::abs(std::hypot(z, t) - 10'000);
    const bool in_the_hole = seconds(rig.elapsed()) - on_s > 5 * std::numbers::pi + 0.01;
    outside += (in_the_hole ? whole : std::min(half, whole)) > 1;
  }
  EXPECT_GT(samples, 10'000);
  EXPECT_EQ(outside, 0) << "the cut leaves its circle by more than a count";
  EXPECT_NEAR(off_s - on_s, 25 * std::numbers::pi, 0.01) << "at 1000 counts/s";
  rig.run_until_quiet();
  EXPECT_NEAR(static_cast<double>(rig.position('Z')), -60, 1) << "10 counts of lead-out and the ramp";
  EXPECT_EQ(rig.position('T'), 10'000);
}

}  // namespace
}  // namespace hw::vme58::proof
