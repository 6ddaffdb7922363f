// Rows of the encoder commands. Tracking (ET) stands with the motion.
#include <cmath>

#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

constexpr AxisId axis_x{0};

/// Step axes with encoders.
Rig steppers() { return Rig::model("4E"); }

void slip_x(Rig& rig, std::int64_t counts) { rig.operate(bench::Slip(axis_x, Steps(counts))); }
void jam_x(Rig& rig, bool on) { rig.operate(bench::Jam(axis_x, on)); }

std::int64_t encoder(Rig& rig) { return std::atoll(rig.value("AX RE").c_str()); }

/// Holding with a brisk correction.
Rig holding_stepper(std::string_view more = "") {
  Rig rig = steppers();
  rig.send("AX HV1000 HG1000 HN " + std::string(more) + " ");
  EXPECT_FALSE(rig.command_error());
  return rig;
}

}  // namespace

VME58_FORM("vme58.enc.ER") {
  // 1000 counts of the encoder are 400 of the motor. With that ratio the move leaves no error.
  for (const bool told : {true, false}) {
    Rig rig = steppers();
    AxisPlace place;
    place.counts_per_step = 2.5;
    rig.place('X', place);
    rig.send(told ? "AX ER1000,400 HN MR400 GO ID " : "AX HN MR400 GO ID ");
    rig.run_until_done("X");
    EXPECT_EQ(encoder(rig), 1000);
    EXPECT_EQ(rig.position('X'), 400);
    EXPECT_EQ(rig.value("EA").substr(3, 1), told ? "P" : "N") << "1:1 otherwise (decision M80)";
  }
}

VME58_FORM("vme58.enc.HV") {
  Rig rig = holding_stepper("HV100");
  slip_x(rig, -1000);
  rig.run_for(1s);
  EXPECT_NEAR(static_cast<double>(encoder(rig)), -900, 3) << "100 counts/s at most";
  rig.run_for(20s);
  EXPECT_EQ(encoder(rig), 0);
  Rig zero = holding_stepper("HV0");
  slip_x(zero, -10);
  zero.run_for(10s);
  EXPECT_EQ(encoder(zero), -10) << "0 after a reset: no correction (decision M80)";
}

VME58_FORM("vme58.enc.HG") {
  // Error times gain: 100 counts at HG 2 begin with 200 counts/s and come down slower and slower.
  Rig rig = holding_stepper("HG2");
  slip_x(rig, -100);
  rig.run_for(500ms);
  EXPECT_NEAR(static_cast<double>(encoder(rig)), -100 * std::exp(-2 * 0.5), 4);
  Rig fast = holding_stepper("HG20");
  slip_x(fast, -100);
  fast.run_for(500ms);
  EXPECT_GT(encoder(fast), -2);
}

VME58_FORM("vme58.enc.HD") {
  Rig rig = holding_stepper("HD5");
  slip_x(rig, -5);
  rig.run_for(1s);
  EXPECT_EQ(encoder(rig), -5) << "in place within 5 counts";
  EXPECT_EQ(rig.value("EA").substr(3, 1), "P");
  slip_x(rig, -1);
  EXPECT_EQ(rig.value("EA").substr(3, 1), "N");
  rig.run_for(1s);
  EXPECT_EQ(encoder(rig), -5) << "back into the band";
}

VME58_FORM("vme58.enc.HF") {
  Rig rig = holding_stepper("ES5 HF");
  EXPECT_EQ(rig.value("AX EA").substr(0, 2), "DD") << "slip detection and holding are off";
  slip_x(rig, -100);
  rig.run_for(1s);
  EXPECT_EQ(encoder(rig), -100);
  EXPECT_EQ(rig.read8(reg::slip), 0);
  // A servo axis is switched off: its moves are command errors (decision M78).
  Rig servo;
  servo.send("AX HF MR100 GO ID ");
  EXPECT_TRUE(servo.command_error());
  servo.run_for(1s);
  EXPECT_EQ(servo.position('X'), 0);
}

VME58_FORM("vme58.enc.HN") {
  Rig rig = holding_stepper();
  EXPECT_EQ(rig.value("AX EA").substr(1, 1), "E");
  slip_x(rig, 77);
  EXPECT_EQ(encoder(rig), 77);
  rig.run_for(1s);
  EXPECT_EQ(encoder(rig), 0) << "brought back";
  EXPECT_EQ(rig.position('X'), 0) << "the command register stays";
  Rig servo;
  servo.send("AX HF HN MR100 GO ID ");
  EXPECT_FALSE(servo.command_error());
  servo.run_until_done("X");
  EXPECT_EQ(servo.position('X'), 100);
}

VME58_FORM("vme58.enc.IP") {
  Rig rig = holding_stepper("HV100 HD2 VL1000");
  rig.send("MR100 GO IP ");
  rig.run_for(50ms);
  slip_x(rig, -50);
  rig.run_for(150ms);
  EXPECT_FALSE(rig.moving('X'));
  EXPECT_EQ(rig.done(), 0) << "the error lies outside the band";
  rig.run_until_done("X");
  EXPECT_EQ(encoder(rig), 98);
  EXPECT_EQ(rig.done(), bit_of('X'));
  rig.send("AA MR10,10; GO IP ");
  rig.run_until_done("XY");
  EXPECT_EQ(rig.done(), bit_of('X') | bit_of('Y')) << "all axes of the last move (decision M53)";
}

VME58_FORM("vme58.enc.ES") {
  Rig rig = steppers();
  rig.send("AX ES10 ");
  EXPECT_EQ(rig.value("EA").substr(0, 1), "E");
  jam_x(rig, true);
  rig.send("MR10 GO ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.read8(reg::slip), 0) << "10 are tolerated";
  rig.send("MR1 GO ID ");
  rig.run_for(1s);
  EXPECT_EQ(rig.read8(reg::slip), bit_of('X'));
  EXPECT_EQ(rig.position('X'), 11) << "a flag, no more";
}

VME58_FORM("vme58.enc.TN") {
  Rig rig = holding_stepper("ES10 TN VL1000");
  rig.send("MR200 GO ");
  rig.run_for(50ms);
  jam_x(rig, true);
  rig.send("MR1000 GO ID ");
  rig.run_for(5s);
  EXPECT_FALSE(rig.moving('X'));
  EXPECT_LT(rig.position('X'), 100) << "stopped where it slipped";
  EXPECT_EQ(rig.room('X'), queue_entries) << "the queue is empty";
  EXPECT_EQ(rig.value("AX EA"), "EDSPNN") << "holding is over, and with it the question of the band";
  EXPECT_EQ(rig.read8(reg::slip), bit_of('X'));
  EXPECT_EQ(rig.done(), 0);
}

VME58_FORM("vme58.enc.TF") {
  Rig rig = steppers();
  rig.send("AX ES10 TN TF MR1000 GO ID ");
  jam_x(rig, true);
  rig.run_until_done("X");
  EXPECT_EQ(rig.position('X'), 1000) << "the flag alone again";
  EXPECT_EQ(rig.read8(reg::slip), bit_of('X'));
}

VME58_FORM("vme58.enc.IS") {
  for (const bool asked : {true, false}) {
    for (const std::uint8_t enable : {control::slip_interrupt, control::done_interrupt}) {
      Rig rig = steppers();
      rig.write8(reg::control, enable | control::interrupts);
      rig.send(asked ? "AX ES10 IS MR100 GO " : "AX ES10 MR100 GO ");
      jam_x(rig, true);
      rig.run_for(1s);
      EXPECT_EQ(rig.bus().interrupt().has_value(), asked) << "with control bit 2, or 4 (decision M93)";
      EXPECT_NE(rig.status() & status::slip, 0) << "the flag comes either way";
    }
  }
}

VME58_FORM("vme58.enc.RL") {
  Rig rig = steppers();
  EXPECT_EQ(visible(rig.ask("RL")), "<lf><cr>NNNN<lf><cr>");
  rig.send("AX ES10 MR100 GO ");
  jam_x(rig, true);
  rig.run_for(1s);
  EXPECT_EQ(rig.value("RL"), "SNNN");
  EXPECT_EQ(rig.value("RL"), "SNNN") << "asking clears nothing";
  EXPECT_EQ(rig.value("AA RL"), "SNNN");
  rig.send("IC ");
  EXPECT_EQ(rig.value("RL"), "NNNN");
}

VME58_FORM("vme58.enc.HE") {
  Rig rig;
  AxisPlace place;
  place.home_from = Steps(1000), place.home_to = Steps(1600), place.index_every = Steps(400);
  rig.place('X', place);
  rig.send("AX HE VL500 AC1000000 HM0 MA0 GO ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.view().load_position[0].value, 1200) << "the index inside the zone, not the switch at 1000";
  EXPECT_EQ(rig.value("EA").substr(4, 1), "H");
}

VME58_FORM("vme58.enc.HS") {
  Rig rig;
  AxisPlace place;
  place.home_from = Steps(1000), place.home_to = Steps(1600), place.index_every = Steps(400);
  rig.place('X', place);
  rig.send("AX HE HS VL500 AC1000000 HM0 MA0 GO ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.view().load_position[0].value, 1000) << "the switch alone";
}

VME58_FORM("vme58.enc.EA") {
  Rig rig = steppers();
  EXPECT_EQ(visible(rig.ask("AX EA")), "<lf><cr><cr>DDNPNN<lf><cr><cr>");
  rig.send("ES5 HN ");
  EXPECT_EQ(rig.value("EA"), "EENPNN");
  slip_x(rig, 3);
  EXPECT_EQ(rig.value("EA"), "EENNNN") << "outside HD, inside ES";
  EXPECT_EQ(Rig().value("AX EA"), "DENPNN") << "a servo loop is closed when power comes on";
}

VME58_FORM("vme58.enc.RE") {
  Rig rig;
  rig.send("AX LP400 MR-1000 GO ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.ask("AX RE"), framed("-600"));
  EXPECT_EQ(rig.ask("AA RE"), framed("-600,0,0,0,0,0,0,0"));
  Rig stepper = steppers();
  stepper.operate(bench::Slip(axis_x, Steps(12)));
  EXPECT_EQ(stepper.value("AX RE"), "12");
  EXPECT_EQ(stepper.value("RP"), "0") << "the command register knows nothing of it";
}

}  // namespace hw::vme58::proof
