// Forms of programs, operation and set-up that loop and compute (p.19, 23, 25; App. A, E, G, O); the others:
// vxm.forms.
#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {

VXM_FORM("vxm.syntax.comment") {
  Rig rig = Rig::online();
  rig.send("I1M400 ;one turn, I1M9,R.K\r");
  EXPECT_EQ(visible(rig.output()), "") << "lasts to the carriage return, over commas and letters";
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M252<cr>I1M400<cr>") << "whose <cr> ends the value too (p.9)";
  rig.send(";I1M8\r");
  EXPECT_EQ(rig.used_bytes(), 4);
  rig.send("E");
  EXPECT_EQ(rig.ask(";rem\r"), ";rem\r") << "echoed like anything else (V05)";
  rig.send("FCP1,R;KV\r");
  EXPECT_EQ(rig.output().substr(0, 1), "^")
      << "behind R its letters are commands to the running program (V05)";
}

VXM_FORM("vxm.op.null") {
  Rig rig = Rig::online_with_slave();
  rig.run("I1M11,I2M22,I3M33,I4M44,");
  EXPECT_EQ(rig.position(4), 44);
  EXPECT_EQ(rig.ask("N"), "");
  for (int motor = 1; motor <= 4; ++motor) EXPECT_EQ(rig.position(motor), 0) << motor;
  EXPECT_EQ(rig.load(1), 11) << "nothing moved";
  rig.run("CI1M11,");
  rig.send("QNF");
  EXPECT_EQ(rig.position(1), 0) << "in local mode too";
  rig.run("CI1M11,P10,");
  rig.send("R");
  rig.run_for(500ms);
  rig.send("N");
  EXPECT_EQ(rig.position(1), 22) << "dropped while a program runs (V13)";
}

VXM_FORM("vxm.op.kill") {
  Rig rig = Rig::online();
  rig.send("U5,U15,I1M100000,I2M5,R");
  rig.run_for(3s);  // 1 s of ramp over 1000 steps, then 2000 steps/s
  EXPECT_EQ(rig.ask("K"), "^");
  EXPECT_NEAR(static_cast<double>(rig.position(1)), 5000, 1) << "stopped within one step (V61)";
  EXPECT_EQ(rig.ask("$"), std::string(1, '\0')) << "outputs low";
  EXPECT_EQ(rig.ask("V"), "R");
  const auto stopped_at = rig.position(1);
  rig.run_for(10s);
  EXPECT_EQ(rig.position(1), stopped_at);
  EXPECT_EQ(rig.position(2), 0) << "the program is over";
  EXPECT_EQ(rig.output(), "");
  EXPECT_EQ(rig.used_bytes(), 12) << "programs kept";
  EXPECT_EQ(rig.ask("K"), "^") << "with nothing running (V17)";
  rig.send("G");
  EXPECT_EQ(rig.ask("K"), "^\r") << "(V15)";
  rig.send("Q");
  EXPECT_EQ(rig.ask("K"), "") << "dropped in local mode (V12)";
}

VXM_FORM("vxm.op.decel") {
  Rig rig = Rig::online();
  rig.send("I1M100000,I2M5,R");
  rig.run_for(3s);
  EXPECT_EQ(rig.ask("D"), "");
  rig.run_for(1100ms);  // 1 s of ramp
  EXPECT_EQ(rig.output(), "^");
  EXPECT_NEAR(static_cast<double>(rig.position(1)), 6000, 1);
  EXPECT_EQ(rig.position(2), 5) << "the next command follows (V60)";
  EXPECT_NEAR(std::atof(rig.ask("*").c_str()), 5.0 - 2.5, 2.5) << "motor 2 slowed last";
  EXPECT_EQ(rig.ask("D"), "") << "outside an index it does nothing";
  EXPECT_EQ(rig.ask("V"), "R");
}

VXM_FORM("vxm.op.echo.on") {
  Rig rig;
  EXPECT_EQ(rig.ask("V"), "J");
  EXPECT_EQ(rig.ask("E"), "E") << "is itself echoed (V06)";
  EXPECT_TRUE(rig.online_lamp());
  EXPECT_EQ(rig.ask("I1M400\r"), "I1M400\r");
  EXPECT_EQ(rig.ask("x?!\n;rem\r").substr(0, 1), "x") << "all characters";
  EXPECT_EQ(rig.ask("X"), "X+0000000\r");
  EXPECT_EQ(rig.ask("R"), "R");
  EXPECT_EQ(rig.ask("V"), "VB") << "during a run too";
  rig.run_until_output("^");
  rig.output();
  EXPECT_EQ(rig.ask("F"), "") << "changes it at once";
  EXPECT_EQ(rig.ask("V"), "R");
}

VXM_FORM("vxm.op.record") {
  Rig rig = Rig::online();
  rig.send("I1M521,U6,R");
  EXPECT_TRUE(rig.run_until_output("W"));
  rig.output();
  EXPECT_EQ(rig.ask("!"), "");
  EXPECT_EQ(rig.ask("G"), "^");
  EXPECT_EQ(visible(rig.ask("x")), "+0000521<cr>+0000000<cr>+0000000<cr>+0000000<cr>");
  EXPECT_EQ(rig.ask("!"), "") << "idle";
  EXPECT_EQ(visible(rig.ask("x")), "+0000521<cr>+0000521<cr>+0000000<cr>+0000000<cr>");
  rig.send("CR");
  EXPECT_EQ(visible(rig.ask("x")), "+0000000<cr>+0000000<cr>+0000000<cr>+0000000<cr>")
      << "zeroed at each run";
  rig.send("Q!F");
  EXPECT_EQ(visible(rig.ask("x")).substr(0, 12), "+0000000<cr>") << "dropped in local mode";
}

VXM_FORM("vxm.op.save") {
  Rig rig = Rig::online();
  const auto version = rig.emulator().memory_version();
  rig.send("I1M400,setL1M-2,rsm");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.output(), "^") << "when finished";
  EXPECT_NE(rig.emulator().memory_version(), version);
  rig.power_cycle();
  EXPECT_EQ(rig.ask("V"), "J");
  rig.send("F");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M252<cr>I1M400<cr>");
  EXPECT_EQ(rig.ask("getL1M"), "-2\r");
  rig.send("P1,R");
  EXPECT_EQ(rig.ask("rsm"), "") << "dropped while a program runs";
  rig.run_until_output("^");
  rig.run_for(5s);
  EXPECT_EQ(rig.output(), "^");
  rig.send("Q");
  EXPECT_EQ(rig.ask("rsm"), "") << "dropped in local mode";
  rig.run_for(5s);
  EXPECT_EQ(rig.output(), "");
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

VXM_FORM("vxm.set.pulsewidth") {
  expect_setting(form, "getPA", "1", "4");
  Rig rig = Rig::online();
  expect_kept(rig, "getPA", {"setPA0", "setPA256", "setPA"});
  rig.send("setP1M10,setPA200,");
  rig.run("I1M12,");
  ASSERT_EQ(rig.pulses().size(), 1u);
  EXPECT_EQ(rig.pulses()[0].width, 2ms) << "the manual's second example, p.42";
}

}  // namespace hw::vxm::proof
