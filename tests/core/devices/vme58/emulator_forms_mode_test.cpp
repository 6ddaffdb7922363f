// Rows of axis selection, system control and user units.
// Those that neither loop nor compute stand in vme58.forms.
#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

/// Later commands go to this axis and to no other.
void check_selector(const Form& f) {
  const char letter = f.example[1];
  Rig rig;
  rig.send(std::string(letter == 'X' ? "AY " : "AX ") + f.example);
  rig.send(" LP321 ");
  EXPECT_EQ(rig.value("RP"), "321");
  for (const char other : axis_letters) EXPECT_EQ(rig.position(other), other == letter ? 321 : 0) << other;
  // Where that axis is not fitted the selector is refused, and the one before stays.
  Rig small = Rig::model("2S2");
  small.send("AY LP5 ");
  small.send(f.example + " LP6 ");
  const bool fitted = axis_letters.find(letter) < 4;
  EXPECT_EQ(small.command_error(), !fitted);
  EXPECT_EQ(small.position('Y'), fitted && letter != 'Y' ? 5 : 6);
}

const bool selectors_registered = [] {
  for (const char letter : axis_letters)
    register_form(std::string("vme58.axis.A") + letter, check_selector, __FILE__, __LINE__);
  return true;
}();

/// Seconds that a move of 100,000 counts takes with what was set.
double seconds_of_move(Rig& rig, std::string_view set) {
  rig.send("AX VL100000 AC100000 VB0 " + std::string(set) + " LP0 CA MR200000 GO ID ");
  return seconds(rig.run_until_done("X"));
}

}  // namespace

VME58_FORM("vme58.axis.AA") {
  Rig rig;
  rig.send("AA LP1,2,,4; ");
  EXPECT_EQ(rig.value("RP"), "1,2,0,4,0,0,0,0");
  EXPECT_EQ(Rig::model("4E").value("AA RP"), "0,0,0,0") << "as many values as axes";
  // One line after the other: the second move waits for the first although other axes make it.
  rig.send("VL1000,1000; MR1000; GO MR,1000; GO ");
  rig.run_for(500ms);
  EXPECT_TRUE(rig.moving('X'));
  EXPECT_FALSE(rig.moving('Y'));
  rig.run_for(1s);
  EXPECT_TRUE(rig.moving('Y'));
}

// --- system ------------------------------------------------------------------------------------------------

VME58_FORM("vme58.sys.LF") {
  Rig rig;
  rig.limit('X', '+', true);
  rig.send("AX LF MR1000 GO ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 1000) << "past the switch";
  EXPECT_NE(rig.read8(reg::limit), 0) << "the switch can still be seen";
}

VME58_FORM("vme58.sys.CN") {
  // Half a cosine over the time that the linear ramp would take: the same duration and way (decision M45),
  // another speed on the way up.
  Rig linear, cosine;
  EXPECT_NEAR(seconds_of_move(linear, "PF"), seconds_of_move(cosine, "CN"), 2e-3);
  cosine.send("AX CA MR200000 GO ");
  linear.send("AX CA MR200000 GO ");
  linear.run_for(250ms);
  cosine.run_for(250ms);
  EXPECT_NEAR(static_cast<double>(linear.velocity('X')), 25'000, 50);
  EXPECT_NEAR(static_cast<double>(cosine.velocity('X')), 50'000 * (1 - 0.70711), 100);
  EXPECT_EQ(cosine.position('X') > 200'000, true);
}

VME58_FORM("vme58.sys.PN") {
  Rig linear, parabolic;
  // Acceleration falls with the speed: it takes longer, the more the larger n is.
  const double plain = seconds_of_move(linear, "PF"), cut = seconds_of_move(parabolic, "PN5");
  EXPECT_GT(cut, plain + 0.05);
  EXPECT_GT(seconds_of_move(parabolic, "PN9"), cut + 0.05);
  parabolic.send("PN0 ");
  EXPECT_TRUE(parabolic.command_error()) << "1 to 10 (decision M45)";
  parabolic.send("PN11 ");
  EXPECT_TRUE(parabolic.command_error());
}

VME58_FORM("vme58.sys.PF") {
  Rig rig;
  const double linear = seconds_of_move(rig, "");
  const double parabolic = seconds_of_move(rig, "PN10");
  EXPECT_GT(parabolic, linear + 0.1);
  EXPECT_NEAR(seconds_of_move(rig, "PF"), linear, 1e-3);
}

VME58_FORM("vme58.sys.RS") {
  Rig rig;
  rig.write16(at::reserved1, 0x4711);
  rig.write8(reg::vector, 7);
  rig.write8(reg::control, 0x90);
  rig.send("EN AY LP500 AC1000 VL7 VB3 KP5 HH UU10 ER2,1 ID JG100 BL8 AF XX ");
  rig.run_for(1s);
  rig.send("RS AX LP7 ");  // what stands behind it is lost
  EXPECT_EQ(rig.status(), 0);
  EXPECT_EQ(rig.read16(at::output_put_index), 0);
  EXPECT_EQ(rig.read16(at::output_get_index), 0);
  EXPECT_EQ(rig.read16(at::reserved1), 0);
  rig.run_for(100ms);
  EXPECT_EQ(rig.status(), status::initialized);
  EXPECT_EQ(rig.read8(reg::vector), 0);
  EXPECT_EQ(rig.done(), 0);
  EXPECT_EQ(visible(rig.ask("RP")), visible(framed("0"))) << "axis X, no echo";
  EXPECT_EQ(rig.value("AA RP"), "0,0,0,0,0,0,0,0");
  EXPECT_EQ(rig.value("RC"), "2000000,2000000,2000000,2000000,2000000,2000000,2000000,2000000");
  EXPECT_EQ(rig.axis_value('Y', AxisValue::maximum_velocity), default_velocity);
  EXPECT_EQ(rig.axis_value('Y', AxisValue::base_velocity), 0);
  EXPECT_EQ(rig.axis_value('Y', AxisValue::proportional_gain), 0);
  EXPECT_EQ(rig.read8(reg::home), 0);
  EXPECT_FALSE(rig.moving('Y'));
  EXPECT_FALSE(rig.line_low(8));
  EXPECT_TRUE(rig.aux_high('Y'));
  rig.send("LP3 ");
  EXPECT_EQ(rig.value("RU"), "3.0") << "user units are off";
}

}  // namespace hw::vme58::proof
