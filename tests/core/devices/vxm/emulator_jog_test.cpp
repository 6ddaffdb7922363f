// Jog buttons, the analog joystick, the lamps (p.7; App. H, J; p.30).
#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {
namespace {

struct Blinks {
  int rises = 0;
  bool high_first = false, high_last = false;
};

// Watches a lamp event by event.
Blinks watch(Rig& rig, bool (Rig::*lamp)() const, Duration time) {
  Blinks seen;
  bool before = seen.high_first = (rig.*lamp)();
  for (const Duration end = rig.elapsed() + time; rig.elapsed() < end;) {
    rig.run_for(1ms);
    const bool now = (rig.*lamp)();
    seen.rises += now && !before;
    before = now;
  }
  seen.high_last = before;
  return seen;
}

}  // namespace

TEST(VxmJog, OneStepOnAPressThenASlewAfterThreeTenths) {
  Rig rig;
  rig.press("1+");
  EXPECT_EQ(rig.load(1), 1) << "at once";
  rig.run_for(299ms);
  EXPECT_EQ(rig.load(1), 1);
  rig.run_for(1ms + 1s);
  EXPECT_NEAR(static_cast<double>(rig.load(1)), 1001, 2) << "ramp to 2000 steps/s";
  rig.run_for(1s);
  EXPECT_NEAR(static_cast<double>(rig.load(1)), 3001, 2);
  rig.release("1+");
  EXPECT_EQ(rig.ask("V"), "b");
  rig.run_for(1100ms);
  EXPECT_NEAR(static_cast<double>(rig.load(1)), 4001, 3) << "ramps down";
  EXPECT_EQ(rig.ask("V"), "J");
}

TEST(VxmJog, EachButtonItsMotorAndDirection) {
  Rig rig;
  for (const char* button : {"1+", "1+", "1-", "2-", "2-", "2-", "2+"}) rig.click(button);
  EXPECT_EQ(visible(rig.ask("D")), "X+0000001<cr>Y-0000002<cr>");
  rig.send("F");
  EXPECT_EQ(rig.ask("#"), "2\r") << "the motor jogged last (p.18)";
}

TEST(VxmJog, StopHeldDownMakesItSlow) {
  Rig rig;
  rig.press("Stop");
  rig.press("1-");
  rig.run_for(300ms + 10s);
  EXPECT_NEAR(static_cast<double>(rig.load(1)), -391, 3) << "39 steps/s (p.7)";
  rig.release("1-");
  rig.release("Stop");
  rig.run_for(1s);
  EXPECT_EQ(rig.ask("V"), "J");
}

TEST(VxmJog, OnlineTheJogInputsAreDisabled) {
  Rig rig = Rig::online();
  rig.click("1+", 1s);
  EXPECT_EQ(rig.load(1), 0) << "p.8";
  rig.send("Q");
  rig.press("1+");
  rig.run_for(2s);
  EXPECT_EQ(rig.ask("V"), "b");
  rig.send("F");
  rig.run_for(2s);
  const auto stands = rig.load(1);
  rig.run_for(5s);
  EXPECT_EQ(rig.load(1), stands) << "F ends a jog at the panel (V102)";
  EXPECT_EQ(rig.ask("V"), "R");
}

TEST(VxmJog, BothButtonsOfAMotor) {
  Rig rig;
  rig.press("1+");
  rig.press("1-");
  rig.run_for(100ms);
  rig.release("1-");
  rig.release("1+");
  rig.run_for(5s);
  EXPECT_LE(std::llabs(rig.load(1)), 2);
  EXPECT_EQ(rig.ask("V"), "J");
}

TEST(VxmJog, LimitsStopAJog) {
  Rig rig;
  AxisPlace travel;
  travel.plus = Steps(700);
  rig.place(1, travel);
  rig.press("1+");
  rig.run_for(10s);
  EXPECT_EQ(rig.load(1), 700);
  rig.release("1+");
  rig.click("1-");
  EXPECT_EQ(rig.load(1), 699);
}

TEST(VxmJog, InputTwoSelectsTheSecondSpeed) {
  Rig rig = Rig::online();
  rig.send("setj1M1000,setJ1M100,Q");
  rig.input(2, true);
  rig.press("1+");
  rig.run_for(300ms + 50ms);
  const auto start = rig.load(1);
  rig.run_for(10s);
  EXPECT_NEAR(static_cast<double>(rig.load(1) - start), 1000, 2);
}

TEST(VxmJog, TheSlavesButtonsJogTheSlavesMotors) {
  Rig rig = Rig::with_slave();
  rig.click("3+");
  rig.click("4-");
  EXPECT_EQ(visible(rig.ask("D")), "X+0000000<cr>Y+0000000<cr>Z+0000001<cr>T-0000001<cr>");
}

TEST(VxmJog, WhereAJogEndsProgramsGoOn) {
  Rig rig;
  for (int i = 0; i < 5; ++i) rig.click("1+");
  rig.send("F");
  rig.run("IA1M0,");
  EXPECT_EQ(rig.load(1), 0) << "registers count jogs too (App. H)";
}

TEST(VxmJog, StopDuringAJogInAWaitEndsBoth) {
  Rig rig = Rig::online();
  rig.send("U2,U0,R");
  rig.press("1+");
  rig.run_for(2s);
  rig.press("Stop");
  EXPECT_TRUE(rig.run_until_output("^", 2s));
  EXPECT_EQ(rig.output(), "ES^");
  rig.release("Stop");
  rig.release("1+");
  rig.send("Q");
  const auto stands = rig.load(1);
  rig.click("1+");
  EXPECT_EQ(rig.load(1), stands + 1) << "the buttons work as before";
}

TEST(VxmJoystick, StandsAtTheCentreAndInTheDeadBand) {
  Rig rig = Rig::online();
  rig.send("setjA1M4,Q");
  rig.run_for(10s);
  EXPECT_EQ(rig.load(1), 0);
  rig.analog(1, 512 + 15);
  rig.run_for(10s);
  EXPECT_EQ(rig.load(1), 0) << "dead band of 40";
  rig.analog(1, 1024);
  rig.run_for(5s);
  EXPECT_NE(rig.load(1), 0);
  EXPECT_EQ(rig.ask("V"), "b");
  rig.analog(1, 512);
  rig.run_for(5s);
  const auto stands = rig.load(1);
  rig.run_for(5s);
  EXPECT_EQ(rig.load(1), stands);
  EXPECT_EQ(rig.ask("V"), "J");
}

TEST(VxmJoystick, FartherIsFasterAndTheOtherWayIsBack) {
  Rig rig = Rig::online();
  rig.send("setjA1M4,Q");
  const auto distance_at = [&](int value) {
    rig.analog(1, value);
    rig.run_for(2s);
    const auto start = rig.load(1);
    rig.run_for(1s);
    return rig.load(1) - start;
  };
  const auto full = distance_at(1024), half = distance_at(768), back = distance_at(0);
  EXPECT_NEAR(static_cast<double>(std::llabs(full)), 1000, 2) << "250 steps/s for each unit of the range";
  EXPECT_LT(std::llabs(half), std::llabs(full) * 3 / 4);
  EXPECT_GT(std::llabs(half), std::llabs(full) / 4);
  EXPECT_NEAR(static_cast<double>(back), -static_cast<double>(full), 5);
}

TEST(VxmJoystick, InputThreeSelectsTheSecondMotor) {
  Rig rig = Rig::online();
  rig.send("setI3,setjA1M4,setjA2M4,Q");
  rig.input(3, true);
  rig.analog(1, 1024);
  rig.run_for(2s);
  EXPECT_EQ(rig.load(1), 0);
  EXPECT_NE(rig.load(2), 0);
}

TEST(VxmJoystick, TheCentreIsReadAtPowerUp) {
  Rig rig = Rig::online();
  rig.send("setjA1M4,rsm");
  rig.run_until_output("^");
  rig.analog(1, 800);
  rig.power_cycle();
  rig.run_for(5s);
  EXPECT_EQ(rig.load(1), 0) << "off-centre at power-up is taken for the centre (p.54)";
  rig.analog(1, 512);
  rig.run_for(5s);
  EXPECT_NE(rig.load(1), 0) << "the caution of p.54";
}

TEST(VxmJoystick, OnlineItRests) {
  Rig rig = Rig::online();
  rig.send("setjA1M4,");
  rig.analog(1, 1024);
  rig.run_for(5s);
  EXPECT_EQ(rig.load(1), 0);
}

TEST(VxmLamps, PowerUpSequence) {
  Rig rig;
  rig.operate(bench::PowerCycle{});
  EXPECT_TRUE(rig.power_lamp());
  EXPECT_TRUE(rig.online_lamp());
  rig.run_for(900ms);
  EXPECT_TRUE(rig.online_lamp()) << "both for one second (p.7)";
  rig.run_for(200ms);
  EXPECT_FALSE(rig.online_lamp());
  const Blinks power = watch(rig, &Rig::power_lamp, 8s);
  EXPECT_NEAR(power.rises, 6, power.high_first ? 0 : 1) << "then Power flashes six times";
  EXPECT_TRUE(power.high_last);
  EXPECT_FALSE(rig.online_lamp());
  EXPECT_EQ(watch(rig, &Rig::power_lamp, 5s).rises, 0) << "and stays lit";
}

TEST(VxmLamps, CommandsAreTakenDuringTheSequence) {
  Rig rig;
  rig.operate(bench::PowerCycle{});
  EXPECT_EQ(rig.ask("FV"), "R") << "V18";
  rig.send("I1M400,R");
  EXPECT_TRUE(rig.run_until_output("^", 2s));
  rig.run_for(10s);
  EXPECT_TRUE(rig.online_lamp());
  EXPECT_TRUE(rig.power_lamp());
}

TEST(VxmLamps, OnlineLampShowsTheMode) {
  Rig rig;
  EXPECT_FALSE(rig.online_lamp());
  for (const char mode : {'E', 'F', 'G'}) {
    rig.send(std::string(1, mode));
    EXPECT_TRUE(rig.online_lamp()) << mode;
    rig.send("Q");
    EXPECT_FALSE(rig.online_lamp()) << mode;
  }
}

TEST(VxmLamps, AButtonHeldAtPowerUpFlashesAndDoesNothing) {
  for (const char* button : {"1+", "Run", "Stop"}) {
    Rig rig = Rig::online();
    rig.send("I1M500,rsm");
    rig.run_until_output("^");
    rig.press(button);
    rig.operate(bench::PowerCycle{});
    rig.run_for(10s);
    EXPECT_GT(watch(rig, &Rig::power_lamp, 10s).rises, 10) << button << ": rapidly and continuously (p.30)";
    EXPECT_EQ(rig.load(1), 0) << button;
    rig.release(button);
    rig.run_for(10s);
    EXPECT_EQ(watch(rig, &Rig::power_lamp, 2s).rises, 0) << button << ": released to recover";
    rig.click("1+");
    EXPECT_EQ(rig.load(1), 1) << button;
  }
}

TEST(VxmLamps, ErrorsFlashBothLamps) {
  Rig rig = Rig::online();
  rig.send("U7,I1M100,R");
  EXPECT_TRUE(rig.run_until_output("EC"));
  EXPECT_GT(watch(rig, &Rig::power_lamp, 5s).rises, 5);
  EXPECT_GT(watch(rig, &Rig::online_lamp, 5s).rises, 5);
  rig.send("K");
  EXPECT_EQ(watch(rig, &Rig::power_lamp, 5s).rises, 0);
  EXPECT_TRUE(rig.power_lamp());
  EXPECT_TRUE(rig.online_lamp());
}

}  // namespace hw::vxm::proof
