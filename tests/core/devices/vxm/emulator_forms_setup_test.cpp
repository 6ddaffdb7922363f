// Set-up commands (p.25; App. C, D, F, H, J, M, N, O).
#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {
namespace {

// Out of range or without a number: the value stays (V09, V10).
void expect_kept(Rig& rig, const std::string& query, const std::vector<std::string>& commands) {
  const std::string before = rig.ask(query);
  for (const std::string& c : commands) {
    EXPECT_EQ(rig.ask(c + ","), "") << c;
    EXPECT_EQ(visible(rig.ask(query)), visible(before)) << c;
  }
}

AxisPlace travel_to(std::int64_t plus) {
  AxisPlace place;
  place.plus = Steps(plus);
  return place;
}

}  // namespace

VXM_FORM("vxm.set.motor") {
  expect_setting(form, "getM1M", "0", "3");
  Rig rig = Rig::online();
  expect_kept(rig, "getM2M", {"setM2M7", "setM2M-1", "setM2M", "setM5M1"});
  rig.send("setM2M6,setM1M0,");
  EXPECT_EQ(rig.ask("getM2M"), "6\r");
  rig.send("rsm");
  rig.run_until_output("^");
  rig.power_cycle();
  rig.send("F");
  EXPECT_EQ(rig.ask("getM2M"), "6\r") << "saved";
}

VXM_FORM("vxm.set.motor.full") {
  expect_setting(form, "getM1M", "0", "3");
  Rig rig = Rig::online();
  rig.send("setMa1M5,");
  EXPECT_EQ(rig.ask("getM1M"), "0\r") << "a printed slip: case matters (V08)";
  expect_kept(rig, "getM1M", {"setMA1M7", "setMA1M"});
}

VXM_FORM("vxm.set.baud") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.emulator().rate(), 9600);
  rig.send("setB38");
  EXPECT_EQ(rig.emulator().rate(), 9600) << "after its ender (V87)";
  rig.send(",");
  EXPECT_EQ(rig.emulator().rate(), 38400);
  rig.send("setB19,");
  EXPECT_EQ(rig.emulator().rate(), 19200);
  for (const char* wrong : {"setB10,", "setB9600,", "setB,", "setB-9,"}) {
    rig.send(wrong);
    EXPECT_EQ(rig.emulator().rate(), 19200) << wrong;
  }
  rig.send("rsm");
  rig.run_until_output("^");
  rig.power_cycle();
  EXPECT_EQ(rig.emulator().rate(), 19200) << "saved";
  rig.send("setB9,");
  EXPECT_EQ(rig.emulator().rate(), 19200) << "dropped in local mode";
  rig.send("FsetB9,");
  EXPECT_EQ(rig.emulator().rate(), 9600);
}

VXM_FORM("vxm.set.mode") {
  expect_setting(form, "getDM", "1", "3");
  Rig rig = Rig::online();
  rig.send("setDM3,");
  rig.run("I1M400,I2M400,");
  EXPECT_EQ(rig.position(1), 400);
  EXPECT_EQ(rig.load(1), -400) << "motor 1 inverted";
  EXPECT_EQ(rig.load(2), 400);
  rig.send("setDM4,");
  EXPECT_EQ(rig.ask("getDM"), "5\r") << "bit 0 is always 1 (V85)";
  rig.run("I1M400,I2M400,");
  EXPECT_EQ(rig.load(1), 0);
  EXPECT_EQ(rig.load(2), 0);
  expect_kept(rig, "getDM", {"setDM256", "setDM", "setDM-1"});
}

VXM_FORM("vxm.set.mode.nf90") {
  expect_setting(form, "getDM", "1", "9");
  Rig rig = Rig::online();
  expect_dropped(rig, "L-0");
  rig.send("setDM9,L-0,");
  EXPECT_EQ(rig.used_bytes(), 1);
}

VXM_FORM("vxm.set.factory") {
  Rig rig = Rig::online();
  rig.send("setj1M77,setM1M4,setDM3,I1M400,PM2,I1M5,rsm");
  rig.run_until_output("^");
  rig.send("P1,RsetD0,");
  rig.run_for(1s);
  rig.output();
  EXPECT_EQ(rig.ask("getM1M"), "4\r") << "dropped while a program runs";
  EXPECT_EQ(rig.ask("setD0"), "") << "has a value, so it waits for its ender";
  EXPECT_EQ(rig.ask(","), "EN");
  EXPECT_EQ(rig.ask("V"), "J") << "afterwards as after res (V88)";
  rig.send("F");
  EXPECT_EQ(rig.ask("getj1M"), "2000\r");
  EXPECT_EQ(rig.ask("getM1M"), "0\r");
  EXPECT_EQ(rig.ask("getDM"), "1\r");
  EXPECT_EQ(rig.ask("M"), "256\r");
  rig.power_cycle();
  rig.send("FPM2,");
  EXPECT_EQ(rig.ask("M"), "256\r") << "saved memory is erased too";
  EXPECT_EQ(rig.ask("getM1M"), "0\r");
  rig.send("QsetD0,F");
  EXPECT_EQ(rig.output().find("EN"), std::string::npos) << "dropped in local mode";
}

VXM_FORM("vxm.set.deadband") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("getDA"), "40\r");
  rig.send("setDA20,");
  EXPECT_EQ(rig.ask("getDA"), "20\r");
  rig.send("setDA100,");
  EXPECT_EQ(rig.ask("getDA"), "100\r");
  expect_kept(rig, "getDA", {"setDA19", "setDA101", "setDA"});
  rig.send("setDA40,");
  EXPECT_EQ(rig.ask("getDA"), "40\r");
}

VXM_FORM("vxm.set.jog1") {
  expect_setting(form, "getj1M", "2000", "1000");
  Rig rig = Rig::online();
  expect_kept(rig, "getj1M", {"setj1M6001", "setj1M", "setj5M1", "setj1M-1"});
  rig.send("setj1M100,Q");
  rig.press("1+");
  rig.run_for(300ms + 10s);
  // One step on the press; 0.05 s of ramp over 2.5 steps; 100 steps/s.
  EXPECT_NEAR(static_cast<double>(rig.load(1)), 1 + 2.5 + 995, 2);
}

VXM_FORM("vxm.set.jog1.off") {
  Rig rig = Rig::online();
  rig.send("setj1M0,");
  EXPECT_EQ(rig.ask("getj1M"), "0\r");
  rig.send("Q");
  rig.click("1+", 1s);
  EXPECT_EQ(rig.load(1), 0);
  rig.click("2+");
  EXPECT_EQ(rig.load(2), 1) << "motor 2 still jogs";
}

VXM_FORM("vxm.set.jog2") {
  expect_setting(form, "getJ1M", "2000", "1000");
  Rig rig = Rig::online();
  expect_kept(rig, "getJ1M", {"setJ1M39", "setJ1M0", "setJ1M6001", "setJ1M"});
  rig.send("setJ1M40,");
  rig.send("Q");
  rig.input(2, true);
  rig.press("1+");
  rig.run_for(300ms + 10s);
  EXPECT_NEAR(static_cast<double>(rig.load(1)), 1 + 400, 2) << "while input 2 is low";
}

VXM_FORM("vxm.set.joy1") {
  expect_setting(form, "getjA1M", "0", "1");
  Rig rig = Rig::online();
  expect_kept(rig, "getjA1M", {"setjA1M25", "setjA1M", "setjA1M-1"});
  rig.send("setjA1M4,Q");
  rig.analog(1, 1024);
  rig.run_for(1s);  // past its ramp
  const auto start = rig.load(1);
  rig.run_for(10s);
  EXPECT_NEAR(static_cast<double>(std::llabs(rig.load(1) - start)), 10000, 100) << "250 steps/s times 4";
}

VXM_FORM("vxm.set.joy1.off") {
  Rig rig = Rig::online();
  rig.send("setjA1M4,setjA1M0,");
  EXPECT_EQ(rig.ask("getjA1M"), "0\r");
  rig.send("Q");
  rig.analog(1, 1024);
  rig.run_for(10s);
  EXPECT_EQ(rig.load(1), 0);
}

VXM_FORM("vxm.set.joy2") {
  expect_setting(form, "getJA1M", "0", "10");
  Rig rig = Rig::online();
  expect_kept(rig, "getJA1M", {"setJA1M25", "setJA1M"});
  rig.send("setJA1M0,");
  EXPECT_EQ(rig.ask("getJA1M"), "0\r") << "V93";
  rig.send("setjA1M4,setJA1M2,Q");
  rig.input(2, true);
  rig.analog(1, 0);
  rig.run_for(1s);
  const auto start = rig.load(1);
  rig.run_for(10s);
  EXPECT_NEAR(static_cast<double>(std::llabs(rig.load(1) - start)), 5000, 50) << "while input 2 is low";
}

VXM_FORM("vxm.set.limit") {
  expect_setting(form, "getL1M", "0", "-2");
  Rig rig = Rig::online();
  expect_kept(rig, "getL1M", {"setL1M3", "setL1M-3", "setL1M"});
  rig.place(1, travel_to(100));
  rig.send("setL1M2,");
  rig.run("I1M500,");
  EXPECT_EQ(rig.position(1), 500) << "2: for homing only";
  rig.run("I1M-500,I1M0,");
  EXPECT_EQ(rig.position(1), 100);
  rig.send("setL1M1,");
  rig.run("I1M-100,I1M500,");
  EXPECT_EQ(rig.position(1), 100) << "1: stops at it";
}

VXM_FORM("vxm.set.pulse") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("getP1M"), "0\r");
  EXPECT_EQ(rig.ask("setP1M4,"), "");
  EXPECT_EQ(rig.ask("getP1M"), "4\r");
  rig.run("I1M12,");
  EXPECT_EQ(rig.pulse_positions(1), (std::vector<std::int64_t>{2, 6, 10})) << "half a period first";
  expect_kept(rig, "getP1M", {"setP1M32768", "setP1M", "setP1M-1"});
}

VXM_FORM("vxm.set.pulse.off") {
  Rig rig = Rig::online();
  rig.send("setP1M4,setP1M0,");
  EXPECT_EQ(rig.ask("getP1M"), "0\r");
  rig.run("I1M12,");
  EXPECT_TRUE(rig.pulses().empty());
}

VXM_FORM("vxm.set.pulsewidth") {
  expect_setting(form, "getPA", "1", "4");
  Rig rig = Rig::online();
  expect_kept(rig, "getPA", {"setPA0", "setPA256", "setPA"});
  rig.send("setP1M10,setPA200,");
  rig.run("I1M12,");
  ASSERT_EQ(rig.pulses().size(), 1u);
  EXPECT_EQ(rig.pulses()[0].width, 2ms) << "the manual's second example, p.42";
}

VXM_FORM("vxm.set.inputs") {
  expect_setting(form, "getI", "7", "67");
  Rig rig = Rig::online();
  rig.send("setI255,");
  EXPECT_EQ(rig.ask("getI"), "249\r") << "bit 7 clears bit 1, bit 6 clears bit 2 (V86)";
  expect_kept(rig, "getI", {"setI256", "setI", "setI-1", "seti7"});
  rig.send("setI0,");
  EXPECT_EQ(rig.ask("getI"), "0\r");
  rig.send("I1M5,Q");
  rig.click("Run");
  rig.run_for(1s);
  EXPECT_EQ(rig.load(1), 0) << "bit 0: Run disabled";
}

VXM_FORM("vxm.set.backlash") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("B1,"), "");
  EXPECT_EQ(rig.ask("B,"), "20\r");
  EXPECT_EQ(rig.used_bytes(), 0);
  EXPECT_TRUE(same_time(rig.run("I1M-100,"), index_time(120) + index_time(20)));
  EXPECT_EQ(rig.position(1), -100);
  expect_kept(rig, "B,", {"B256", "B-1"});
  rig.send("B7,P1,RB9,");
  rig.run_for(1s);
  rig.send("QB9,F");
  rig.output();
  EXPECT_EQ(rig.ask("B,"), "7\r") << "neither in a run nor in local mode";
  rig.send("B0,");
  EXPECT_EQ(rig.ask("B,"), "0\r");
}

VXM_FORM("vxm.set.limitmode") {
  Rig rig = Rig::online();
  rig.place(1, travel_to(100));
  EXPECT_EQ(rig.ask("O1,"), "");
  EXPECT_EQ(rig.used_bytes(), 0);
  rig.send("I1M500,I2M3,R");
  rig.run_until_output("^");
  EXPECT_EQ(rig.output(), "O^");
  EXPECT_EQ(rig.position(2), 3) << "1: the next command follows";
  expect_kept(rig, "O,", {"O4", "O-1"});
  rig.send("QO3,F");
  rig.send("CP1,RO3,");
  rig.run_for(1s);
  rig.output();
  EXPECT_EQ(rig.ask("O,"), "1\r") << "neither in local mode nor in a run";
}

}  // namespace hw::vxm::proof
