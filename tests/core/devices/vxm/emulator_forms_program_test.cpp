// Program management (p.19, App. G) and operation commands (p.23, App. A, E, O).
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

VXM_FORM("vxm.pm.select") {
  Rig rig = Rig::online();
  rig.send("I1M1,PM1,");
  EXPECT_EQ(rig.ask("PM,"), "1\r");
  rig.send("I1M5,I1M6,");
  EXPECT_EQ(visible(rig.ask("lst")), "PM1 M248<cr>I1M5<cr>I1M6<cr>");
  rig.send("PM0,");
  EXPECT_EQ(rig.ask("M"), "252\r") << "selecting clears nothing";
  rig.send("PM4,");
  EXPECT_EQ(rig.ask("PM,"), "4\r");
  EXPECT_EQ(rig.ask("PM5,"), "");
  EXPECT_EQ(rig.ask("PM,"), "4\r") << "5 is out of range";
  rig.send("Q");
  EXPECT_EQ(rig.ask("PM1,"), "");
  rig.send("F");
  EXPECT_EQ(rig.ask("PM,"), "4\r") << "not in local mode";
  rig.send("P1,RPM1,");
  rig.run_for(1s);
  rig.output();
  EXPECT_EQ(rig.ask("PM,"), "4\r") << "not while a program runs";
}

VXM_FORM("vxm.pm.clear") {
  Rig rig = Rig::online();
  rig.send("I1M1,PM2,I1M2,");
  EXPECT_EQ(rig.ask("PM-0,"), "");
  EXPECT_EQ(rig.ask("PM,"), "0\r");
  EXPECT_EQ(rig.ask("M"), "256\r");
  rig.send("PM2,");
  EXPECT_EQ(rig.ask("M"), "252\r") << "only the program named";
  rig.send("PM-2,");
  EXPECT_EQ(rig.ask("M"), "256\r");
  EXPECT_EQ(rig.ask("PM-5,"), "");
  EXPECT_EQ(rig.ask("PM,"), "2\r");
  rig.send("I1M1,Q");
  rig.send("PM-2,F");
  EXPECT_EQ(rig.used_bytes(), 4) << "not in local mode";
  rig.send("P1,RPM-2,");
  rig.run_for(1s);
  EXPECT_EQ(rig.used_bytes(), 7) << "not while a program runs";
}

VXM_FORM("vxm.pm.query") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("PM"), "") << "could still grow into PM1 (V04)";
  EXPECT_EQ(rig.ask("\r"), "0\r");
  EXPECT_EQ(rig.ask("PM3\r"), "");
  EXPECT_EQ(rig.ask("PM\r"), "3\r") << "the manual's sample";
  rig.send("G");
  EXPECT_EQ(rig.ask("PM."), "3\r");
}

VXM_FORM("vxm.pma.set") {
  Rig rig = Rig::online_with_slave();
  rig.send("[PM-1,I1M500,]PM-1,I1M800,");
  EXPECT_EQ(rig.ask("PMA1,"), "");
  EXPECT_EQ(rig.ask("PMA,"), "1\r");
  EXPECT_EQ(rig.used_bytes(), 4);
  EXPECT_TRUE(same_time(rig.run_program(), index_time(800))) << "both at once";
  EXPECT_EQ(rig.position(1), 800);
  EXPECT_EQ(rig.position(3), 500);
  rig.send("PM-2,I1M10,");
  rig.run_program();
  EXPECT_EQ(rig.position(3), 500) << "program 2 is not coupled";
  rig.send("PMA5,");
  EXPECT_EQ(rig.ask("PMA,"), "1\r");
  rig.send("Q");
  rig.send("PMA0,F");
  EXPECT_EQ(rig.ask("PMA,"), "1\r") << "not in local mode";
  rig.send("PM-0,P1,RPMA0,");
  rig.run_for(1s);
  EXPECT_EQ(rig.ask("PMA,"), "1\r") << "not while a program runs";
}

VXM_FORM("vxm.pma.except") {
  Rig rig = Rig::online_with_slave();
  rig.send("[PM-1,I1M500,]PM-1,I1M800,");
  EXPECT_EQ(rig.ask("PMA-0,"), "");
  EXPECT_EQ(rig.ask("PMA,"), "-0\r");
  rig.run_program();
  EXPECT_EQ(rig.position(3), 500) << "every program but 0";
  rig.send("PMA-1,");
  EXPECT_EQ(rig.ask("PMA,"), "-1\r") << "replaces the earlier (V96)";
  rig.run_program();
  EXPECT_EQ(rig.position(1), 1600);
  EXPECT_EQ(rig.position(3), 500);
}

VXM_FORM("vxm.pma.off") {
  Rig rig = Rig::online_with_slave();
  rig.send("[PM-1,I1M500,]PM-1,I1M800,PMA1,");
  EXPECT_EQ(rig.ask("PMA255,"), "");
  EXPECT_EQ(rig.ask("PMA,"), "255\r");
  rig.run_program();
  EXPECT_EQ(rig.position(3), 0);
}

VXM_FORM("vxm.pma.query") {
  Rig rig = Rig::online_with_slave();
  EXPECT_EQ(rig.ask("PMA,"), "255\r");
}

VXM_FORM("vxm.op.quit") {
  Rig rig = Rig::online();
  rig.send("I1M400,");
  EXPECT_TRUE(rig.online_lamp());
  EXPECT_EQ(rig.ask("Q"), "");
  EXPECT_FALSE(rig.online_lamp());
  EXPECT_EQ(rig.ask("V"), "J");
  EXPECT_EQ(rig.ask("Q"), "") << "no effect in local mode";
  rig.send("F");
  EXPECT_EQ(rig.ask("M"), "252\r") << "the program is kept";
  rig.send("P1,R");
  rig.send("Q");
  EXPECT_TRUE(rig.online_lamp()) << "dropped while a program runs (V13)";
}

VXM_FORM("vxm.op.run") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("R"), "^") << "an empty program ends at once";
  rig.send("S1M100,");
  EXPECT_EQ(rig.ask("R"), "^");
  rig.send("CI1M400,");
  EXPECT_EQ(rig.ask("R"), "") << "no ender needed, the reply comes when it ends";
  EXPECT_EQ(rig.ask("V"), "B");
  EXPECT_EQ(rig.ask("R"), "") << "dropped while it runs";
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.output(), "^");
  rig.run_for(10s);
  EXPECT_EQ(rig.output(), "") << "once";
  EXPECT_EQ(rig.ask("M"), "252\r") << "the program is kept";
  rig.send("GR");
  EXPECT_TRUE(rig.run_until_output("^"));
  rig.run_for(1s);
  EXPECT_EQ(rig.output(), "^\r");
  rig.send("Q");
  EXPECT_EQ(rig.ask("R"), "");
  rig.run_for(10s);
  rig.send("F");
  EXPECT_EQ(rig.position(1), 800) << "R is dropped in local mode";
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

VXM_FORM("vxm.op.clear") {
  Rig rig = Rig::online();
  rig.send("S1M500,I1M400,PM1,I2M4,PM0,setj1M77,");
  rig.run_program();
  EXPECT_EQ(rig.ask("C"), "");
  EXPECT_EQ(rig.ask("M"), "256\r");
  EXPECT_EQ(rig.position(1), 400) << "positions kept";
  EXPECT_EQ(rig.ask("getj1M"), "77\r") << "settings kept";
  EXPECT_TRUE(same_time(rig.run("I1M400,"), index_time(400, 500))) << "speeds kept (V57)";
  rig.send("PM1,");
  EXPECT_EQ(rig.ask("M"), "252\r") << "the selected program only";
  rig.send("QCF");
  EXPECT_EQ(rig.ask("M"), "252\r") << "dropped in local mode";
  rig.send("RC");
  rig.run_until_output("^");
  EXPECT_EQ(rig.ask("M"), "252\r") << "dropped while a program runs";
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

VXM_FORM("vxm.op.echo.off") {
  Rig rig;
  EXPECT_EQ(rig.ask("F"), "");
  EXPECT_TRUE(rig.online_lamp());
  EXPECT_EQ(rig.ask("I1M400\r"), "");
  EXPECT_EQ(rig.ask("V"), "R") << "still answers";
  rig.send("G");
  EXPECT_EQ(rig.ask("V"), "R\r");
  EXPECT_EQ(rig.ask("F"), "");
  EXPECT_EQ(rig.ask("V"), "R") << "takes the <cr> of G away (V19)";
  rig.send("P1,R");
  EXPECT_EQ(rig.ask("F"), "");
  EXPECT_EQ(rig.ask("V"), "B");
}

VXM_FORM("vxm.op.group") {
  Rig rig;
  EXPECT_EQ(rig.ask("G"), "");
  EXPECT_TRUE(rig.online_lamp());
  EXPECT_EQ(rig.ask("V"), "R\r");
  EXPECT_EQ(rig.ask("I1M400\r"), "") << "no echo";
  EXPECT_EQ(rig.ask("R"), "");
  EXPECT_EQ(rig.ask("V"), "B") << "no <cr> (App. O)";
  rig.run_until_output("^");
  rig.run_for(1ms);
  EXPECT_EQ(rig.output(), "^\r");
  rig.send("C");
  EXPECT_EQ(rig.ask("U6,R"), "W\r");
  EXPECT_EQ(rig.ask("G"), "^\r");
  EXPECT_EQ(visible(rig.ask("rsm")), "^<cr>");
  rig.send("Q");
  EXPECT_EQ(rig.ask("V"), "J") << "no <cr> (App. O)";
}

VXM_FORM("vxm.op.go") {
  Rig rig = Rig::online();
  rig.send("I1M7,U6,I1M10,R");
  EXPECT_TRUE(rig.run_until_output("W"));
  EXPECT_EQ(rig.output(), "W");
  rig.run_for(1h);
  EXPECT_EQ(rig.ask("V"), "B");
  EXPECT_EQ(rig.ask("G"), "");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.output(), "^") << "G while running does not switch to G mode (V15)";
  EXPECT_EQ(rig.position(1), 17);
  rig.send("C");
  EXPECT_EQ(visible(rig.ask("I1M5,HR")), ":I1M5<cr>");
  rig.send("G");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.position(1), 22) << "releases a hold";
}

VXM_FORM("vxm.op.hold") {
  Rig rig = Rig::online();
  rig.send("I1M400,I2M-30,");
  EXPECT_EQ(rig.ask("H"), "");
  EXPECT_EQ(visible(rig.ask("R")), ":I1M400<cr>");
  rig.run_for(1h);
  EXPECT_EQ(rig.position(1), 0) << "before the command";
  rig.send("G");
  EXPECT_TRUE(rig.run_until_output("\r"));
  EXPECT_EQ(visible(rig.output()), ":I2M-30<cr>");
  EXPECT_EQ(rig.position(1), 400);
  EXPECT_EQ(rig.ask("H"), "") << "toggles the flag off and goes on";
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.output(), "^");
  EXPECT_EQ(rig.position(2), -30);

  rig.send("R");
  EXPECT_EQ(rig.ask("H"), "") << "during a run";
  EXPECT_TRUE(rig.run_until_output("\r"));
  EXPECT_EQ(visible(rig.output()), ":I2M-30<cr>");
  EXPECT_EQ(rig.ask("K"), "^");
  EXPECT_EQ(rig.ask("R"), "") << "K cleared the flag";
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.output(), "^");
  EXPECT_EQ(rig.position(2), -60);
  rig.send("G");
  rig.send("H");
  EXPECT_EQ(visible(rig.ask("R")), ":I1M400<cr>") << "one <cr> in G mode too (V26)";
  rig.send("K");
  rig.send("QHF");
  EXPECT_EQ(rig.ask("R"), "") << "H is dropped in local mode";
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

VXM_FORM("vxm.op.reset") {
  Rig rig = Rig::online();
  rig.send("setj1M77,rsm");
  rig.run_until_output("^");
  rig.send("setj1M99,PM2,I2M5,I1M400,");
  rig.run_program();
  rig.send("S1M10,I1M400,R");
  rig.run_for(1s);
  EXPECT_EQ(rig.ask("res"), "") << "while a program runs";
  EXPECT_EQ(rig.ask("V"), "J") << "local mode, taken from the first byte on (V18)";
  rig.send("F");
  EXPECT_EQ(rig.ask("V"), "R");
  EXPECT_EQ(rig.ask("PM,"), "0\r");
  EXPECT_EQ(rig.ask("#"), "1\r");
  EXPECT_EQ(rig.ask("X"), "+0000000\r");
  EXPECT_EQ(rig.ask("getj1M"), "77\r") << "as saved";
  rig.send("PM2,");
  EXPECT_EQ(rig.ask("M"), "256\r") << "not saved";
  EXPECT_EQ(rig.ask("res"), "") << "on-line";
  EXPECT_EQ(rig.ask("V"), "J");
}

VXM_FORM("vxm.op.delete") {
  Rig rig = Rig::online();
  rig.send("I1M400,P10,");
  EXPECT_EQ(rig.ask("del"), "");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M252<cr>I1M400<cr>");
  rig.send("Q");
  rig.send("del");
  rig.send("F");
  EXPECT_EQ(rig.used_bytes(), 4) << "not in local mode";
  rig.send("R");
  rig.send("del");
  rig.run_until_output("^");
  EXPECT_EQ(rig.used_bytes(), 4) << "not while a program runs";
  rig.send("deldel");
  EXPECT_EQ(rig.used_bytes(), 0) << "nothing more to delete (V36)";
  rig.send("P1,PM1,del");
  rig.send("PM0,");
  EXPECT_EQ(rig.used_bytes(), 3) << "the selected program only";
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

}  // namespace hw::vxm::proof
