// Rows of the PID filter, on an axis to which the bench has given a motor (decision M77), and on one without.
#include <algorithm>
#include <cmath>

#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

Rig motor_on_x(std::string_view gains) {
  Rig rig;
  AxisPlace place;
  place.motor = Motor();
  rig.place('X', place);
  rig.send("AX VL1000000 AC8000000 VB500000 " + std::string(gains) + " ");
  EXPECT_FALSE(rig.command_error());
  return rig;
}

std::int64_t encoder_of_x(Rig& rig) { return std::atoll(rig.value("AX RE").c_str()); }

struct StepReply {
  double overshoot = 0;
  int crossings = 0;
  std::int64_t left = 0;
};

/// A move of 200 counts, as abrupt as the board can command one.
StepReply step_of(std::string_view gains) {
  Rig rig = motor_on_x(gains);
  rig.send("MR200 GO ");
  StepReply r;
  bool below = true;
  for (int ms = 0; ms < 1000; ++ms) {
    rig.run_for(1ms);
    const std::int64_t at = encoder_of_x(rig);
    r.overshoot = std::max(r.overshoot, static_cast<double>(at) / 200 - 1);
    if (at != 200 && (at < 200) != below) ++r.crossings, below = at < 200;
  }
  r.left = encoder_of_x(rig) - 200;
  EXPECT_EQ(rig.position('X'), 200);
  return r;
}

/// Largest error on a slower move.
std::int64_t worst_error(std::string_view gains) {
  Rig rig = motor_on_x(gains);
  rig.send("VB0 VL20000 AC200000 MR10000 GO ");
  std::int64_t worst = 0;
  for (int ms = 0; ms < 600; ++ms) {
    rig.run_for(1ms);
    worst = std::max(worst, std::abs(rig.position('X') - encoder_of_x(rig)));
  }
  return worst;
}

/// The gain can be read in the window; negative ones are refused; an ideal axis does not care.
void expect_gain(std::string_view letters, AxisValue value) {
  Rig rig;
  const std::string gain(letters);
  rig.send("AX " + gain + "12.5 ");
  EXPECT_EQ(rig.axis_value('X', value), 12) << "the whole part (decision M27)";
  rig.send(gain + "-1 ");
  EXPECT_TRUE(rig.command_error());
  EXPECT_EQ(rig.axis_value('X', value), 12);
  rig.send("MR1000 GO ID ");
  rig.run_until_done("X");
  EXPECT_EQ(encoder_of_x(rig), 1000);
  Rig steps = Rig::model("8");
  steps.send("AX " + gain + "1 ");
  EXPECT_TRUE(steps.command_error()) << "servo axes only";
}

}  // namespace

VME58_FORM("vme58.pid.KP") {
  expect_gain("KP", AxisValue::proportional_gain);
  EXPECT_EQ(step_of("KP0").left, -200) << "without it the motor stays";
  const StepReply bad = step_of("KP2 KD0");
  EXPECT_GT(bad.overshoot, 0.25);
  EXPECT_GE(bad.crossings, 5);
}

VME58_FORM("vme58.pid.KD") {
  expect_gain("KD", AxisValue::differential_gain);
  const StepReply good = step_of("KP2 KD6");  // of the data sheet's first two examples
  EXPECT_LT(good.overshoot, 0.05);
  EXPECT_LT(good.crossings, 2);
  EXPECT_LE(std::abs(good.left), 2);
}

VME58_FORM("vme58.pid.KI") {
  expect_gain("KI", AxisValue::integral_gain);
  Rig rig = motor_on_x("KP2 KD6 KI4");
  rig.send("MR200 GO ");
  rig.run_for(5s);
  EXPECT_EQ(encoder_of_x(rig), 200) << "what friction holds is pulled in";
}

VME58_FORM("vme58.pid.KV") {
  expect_gain("KV", AxisValue::velocity_feed_forward);
  EXPECT_LT(worst_error("KP2 KD6 KV0.2"), worst_error("KP2 KD6"));
}

VME58_FORM("vme58.pid.KA") {
  expect_gain("KA", AxisValue::acceleration_feed_forward);
  EXPECT_LT(worst_error("KP2 KD6 KV0.2 KA2.5"), worst_error("KP2 KD6 KV0.2"));
}

VME58_FORM("vme58.pid.KO") {
  // Ten steps of the converter push the motor until five counts of error push back.
  Rig rig = motor_on_x("KP2 KD6 KO40");
  rig.run_for(1s);
  EXPECT_NEAR(static_cast<double>(encoder_of_x(rig)), 20, 3);
  EXPECT_EQ(rig.position('X'), 0);
  EXPECT_EQ(rig.axis_value('X', AxisValue::offset), 40);
  Rig back = motor_on_x("KP2 KD6 KO-40");
  back.run_for(1s);
  EXPECT_NEAR(static_cast<double>(encoder_of_x(back)), -20, 3);
}

VME58_FORM("vme58.pid.KN") {
  // The sum grows at the rate of its interval, so the last counts come in later.
  const auto pulled_in_after = [](std::string_view kn) {
    Rig rig = motor_on_x("KP2 KD6 KI4 " + std::string(kn));
    rig.send("MR200 GO ");
    rig.run_for(200ms);
    int ms = 0;
    while (encoder_of_x(rig) != 200 && ms < 60'000) rig.run_for(10ms), ms += 10;
    return ms;
  };
  EXPECT_LT(pulled_in_after("KN0"), pulled_in_after("KN6"));
  Rig rig;
  rig.send("AX KN16 ");
  EXPECT_TRUE(rig.command_error()) << "decision M79";
  rig.send("KN15 ");
  EXPECT_FALSE(rig.command_error());
}

}  // namespace hw::vme58::proof
