// Status requests (p.24, 25; App. A, D, E, F, H, I, J, N, O).
#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {
namespace {

std::string byte(int value) { return std::string(1, static_cast<char>(value)); }

// A get form: the factory value, then what was set, in every on-line mode with its <cr> (V22).
void expect_get(const Form& form, const std::string& fallback, const std::string& set,
                const std::string& after) {
  Rig rig = rig_for(form);
  EXPECT_EQ(visible(rig.ask(form.example)), visible(fallback + "\r"));
  rig.send(set + ",");
  EXPECT_EQ(visible(rig.ask(form.example)), visible(after + "\r"));
  rig.send("G");
  EXPECT_EQ(visible(rig.ask(form.example)), visible(after + "\r")) << "G mode";
  rig.send("E");
  rig.output();
  EXPECT_EQ(visible(rig.ask(form.example)), visible(form.example + after + "\r")) << "echo";
}

void expect_get_of_each_motor(const std::string& head, const std::string& tail, const std::string& set_tail,
                              const std::string& fallback) {
  Rig rig = Rig::online_with_slave();
  for (const char motor : {'1', '2', '3', '4'}) {
    const std::string query = "get" + head + motor + tail;
    EXPECT_EQ(visible(rig.ask(query)), visible(fallback + "\r")) << query;
    rig.send("set" + head + motor + tail + set_tail + ",");
    EXPECT_EQ(visible(rig.ask(query)), visible(set_tail + "\r")) << query;
  }
}

}  // namespace

VXM_FORM("vxm.status.verify") {
  Rig rig;
  EXPECT_EQ(rig.ask("V"), "J");
  rig.press("1+");
  rig.run_for(1s);
  EXPECT_EQ(rig.ask("V"), "b");
  rig.release("1+");
  rig.run_for(5s);
  EXPECT_EQ(rig.ask("V"), "J");
  rig.send("F");
  EXPECT_EQ(rig.ask("V"), "R");
  rig.send("P1,R");
  EXPECT_EQ(rig.ask("V"), "B");
  rig.run_until_output("^");
  rig.send("G");
  rig.output();
  EXPECT_EQ(rig.ask("V"), "R\r");
}

VXM_FORM("vxm.status.pos1") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("X"), "+0000000\r");
  rig.run("I1M-1200,");
  EXPECT_EQ(rig.ask("X"), "-0001200\r");
  rig.send("R");
  rig.run_for(500ms);
  EXPECT_NEAR(static_cast<double>(rig.position(1)), -1450, 1) << "allowed while it moves";
  rig.send("G");
  EXPECT_EQ(rig.ask("X").size(), 9u);
}

VXM_FORM("vxm.status.pos2") {
  Rig rig = Rig::online();
  rig.run("I2M9201,");
  EXPECT_EQ(rig.ask("Y"), "+0009201\r");
  EXPECT_EQ(rig.ask("X"), "+0000000\r");
  rig.send("R");
  rig.run_for(1s);
  EXPECT_NEAR(static_cast<double>(rig.position(2)), 9201 + 1000, 1);
}

VXM_FORM("vxm.status.pos3") {
  Rig rig = Rig::online_with_slave();
  rig.run("I3M-20,");
  EXPECT_EQ(rig.ask("Z"), "-0000020\r") << "seven digits as the others (V20)";
  rig.run("I3M8388607,I3M22,", 48h);
  EXPECT_EQ(rig.ask("Z"), position_text(8388607 + 2 - 16777216)) << "wraps at 24 bits (V21)";
  rig.send("R");
  rig.run_for(1s);
  EXPECT_EQ(rig.ask("Z"), "") << "not while a motor turns (V13)";

  Rig lone = Rig::online();
  EXPECT_EQ(lone.ask("Z"), "EB") << "without a Slave (V95)";
  EXPECT_EQ(lone.ask("V"), "J") << "and a reset";
}

VXM_FORM("vxm.status.pos4") {
  Rig rig = Rig::online_with_slave();
  rig.run("I4M-200000,");
  EXPECT_EQ(rig.ask("T"), "-0200000\r");
  EXPECT_EQ(rig.ask("Z"), "+0000000\r");
  Rig lone = Rig::online();
  EXPECT_EQ(lone.ask("T"), "EB");
}

VXM_FORM("vxm.status.cap1") {
  Rig rig = Rig::online();
  // The manual's sample, p.44.
  rig.send("I1M521,U6,I1M398,U6,I1M230,U6,R");
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(rig.run_until_output("W"));
    rig.output();
    EXPECT_EQ(rig.ask("x"), "") << "not while a program runs (V13)";
    rig.send("!G");
  }
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(visible(rig.ask("x")), "+0000521<cr>+0000919<cr>+0001149<cr>+0000000<cr>");
  rig.send("!");
  rig.send("N!!");
  EXPECT_EQ(visible(rig.ask("x")), "+0000521<cr>+0000919<cr>+0001149<cr>+0001149<cr>")
      << "a fifth capture is ignored (V27)";
}

VXM_FORM("vxm.status.cap2") {
  Rig rig = Rig::online();
  rig.send("I2M-2004,U6,R");
  ASSERT_TRUE(rig.run_until_output("W"));
  rig.send("!G");
  rig.run_until_output("^");
  EXPECT_EQ(visible(rig.ask("y")), "-0002004<cr>+0000000<cr>+0000000<cr>+0000000<cr>");
  EXPECT_EQ(visible(rig.ask("x")), "+0000000<cr>+0000000<cr>+0000000<cr>+0000000<cr>");
}

VXM_FORM("vxm.status.memory") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("M"), "256\r");
  rig.send("I1M400,");
  EXPECT_EQ(rig.ask("M"), "252\r");
  for (int i = 0; i < 63; ++i) rig.send("I1M400,");
  EXPECT_EQ(rig.ask("M"), "0\r") << "no padding (V22)";
}

VXM_FORM("vxm.status.list") {
  Rig rig = Rig::online();
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M256<cr>");
  rig.send("I400,");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M252<cr>I1M400<cr>");
  rig.send(
      "PM1,IA2M-7,SA3000,A5,LM0,LM-0,L-2,LA3,LA-4,L0,J2,JM3,JM-4,P10,P-20,PA0,PA-5,U77,LM-2,I1M-0,IA1M-0,");
  EXPECT_EQ(
      visible(rig.ask("lst")),
      "PM1 M206<cr>IA2M-7<cr>SA2M3000<cr>A2M5<cr>LM0<cr>LM-0<cr>L-2<cr>LA3<cr>LA-4<cr>L0<cr>J2<cr>JM3<cr>"
      "JM-4<cr>P10<cr>P-20<cr>PA0<cr>PA-5<cr>U77<cr>LM-2<cr>I1M-0<cr>IA1M-0<cr>");
  rig.send("CP007,I1M0003,");
  EXPECT_EQ(visible(rig.ask("lst")), "PM1 M249<cr>P7<cr>I1M3<cr>") << "in canonical form";
}

VXM_FORM("vxm.status.motor") {
  Rig rig = Rig::online_with_slave();
  EXPECT_EQ(rig.ask("#"), "1\r");
  rig.send("I2M5,");
  EXPECT_EQ(rig.ask("#"), "2\r") << "addressed";
  rig.send("A4M3,");
  EXPECT_EQ(rig.ask("#"), "4\r");
  rig.send("CI1M3,PM1,I2M3,PM0,");
  rig.run_program();
  EXPECT_EQ(rig.ask("#"), "1\r") << "run last";
  rig.send("Q");
  rig.click("2+");
  rig.send("F");
  EXPECT_EQ(rig.ask("#"), "2\r") << "jogged last (p.18)";
}

VXM_FORM("vxm.status.decelpos") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("*"), "+0000000\r") << "before any motion (V28)";
  rig.run("I1M-15901,");  // its ramp takes 1000 steps
  EXPECT_EQ(rig.ask("*"), "-0014901\r") << "the manual's sample, p.43";
  rig.run("I2M4000,");
  EXPECT_EQ(rig.ask("*"), "+0003000\r") << "of the motor that slowed last";
  rig.send("CI1M15901,R");
  rig.run_for(3s);
  rig.send("D");
  EXPECT_NEAR(std::atof(rig.ask("*").c_str()), -15901 + 5000, 1) << "while it slows down";
}

VXM_FORM("vxm.status.limits") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("?"), byte(255)) << "none active";
  rig.limit(1, '+', true);
  EXPECT_EQ(rig.ask("?"), byte(253)) << "the manual's table, p.33";
  rig.limit(1, '+', false);
  rig.limit(1, '-', true);
  EXPECT_EQ(rig.ask("?"), byte(254));
  rig.limit(2, '-', true);
  rig.limit(2, '+', true);
  EXPECT_EQ(rig.ask("?"), byte(255 - 1 - 4 - 8));
  rig.send("G");
  EXPECT_EQ(rig.ask("?").size(), 1u) << "never a <cr> (V23)";
  Rig four = Rig::online_with_slave();
  four.limit(3, '-', true);
  four.limit(4, '+', true);
  EXPECT_EQ(four.ask("?"), byte(255 - 16 - 128));
}

VXM_FORM("vxm.status.inputs") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("~"), byte(255));
  rig.input(3, true);
  EXPECT_EQ(rig.ask("~"), byte(191)) << "the manual's table, p.32";
  rig.input(3, false);
  const char* buttons[] = {"1-", "1+", "2-", "2+"};
  for (int i = 0; i < 4; ++i) {
    rig.press(buttons[i]);
    EXPECT_EQ(rig.ask("~"), byte(255 - (1 << i))) << buttons[i];
    rig.release(buttons[i]);
  }
  rig.input(1, true);
  rig.input(2, true);
  EXPECT_EQ(rig.ask("~"), byte(255 - 16 - 32));
  rig.press("Stop");
  EXPECT_EQ(rig.ask("~"), byte(255 - 16 - 32 - 128)) << "Stop is input 4";
  rig.send("G");
  EXPECT_EQ(rig.ask("~").size(), 1u);
}

VXM_FORM("vxm.status.outputs") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("$"), byte(0));
  rig.run("U15,");
  EXPECT_EQ(rig.ask("$"), byte(2)) << "the manual's table, p.33";
  rig.run("U5,U17,U19,");
  EXPECT_EQ(rig.ask("$"), byte(15));
  rig.send("CPA10,R");
  EXPECT_EQ(rig.ask("$"), byte(15)) << "while a program runs";
  rig.send("G");
  EXPECT_EQ(rig.ask("$").size(), 1u);
}

VXM_FORM("vxm.status.analog") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("@"), "512\r");
  rig.analog(1, 1024);
  EXPECT_EQ(rig.ask("@"), "1024\r");
  rig.analog(1, 0);
  EXPECT_EQ(rig.ask("@"), "0\r");
}

VXM_FORM("vxm.status.backlash") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("B"), "") << "waits for its ender (V04)";
  EXPECT_EQ(rig.ask("\r"), "0\r");
  rig.send("B1,");
  EXPECT_EQ(rig.ask("B\r"), "20\r") << "V89";
  rig.send("B255,");
  EXPECT_EQ(rig.ask("B,"), "255\r");
}

VXM_FORM("vxm.status.limitmode") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("O"), "");
  EXPECT_EQ(rig.ask("\r"), "0\r");
  for (const char x : {'1', '2', '3', '0'}) {
    rig.send(std::string("O") + x + ",");
    EXPECT_EQ(rig.ask("O."), std::string(1, x) + "\r");
  }
}

VXM_FORM("vxm.status.digitize") {
  Rig lone;
  EXPECT_EQ(visible(lone.ask("D")), "X+0000000<cr>Y+0000000<cr>") << "a single VXM (App. H)";
  // The manual's sample, p.51.
  Rig rig = Rig::online_with_slave();
  rig.run("I1M201,I2M-1294010,I4M80000,");
  EXPECT_EQ(rig.ask("D"), "") << "not on-line";
  rig.send("Q");
  EXPECT_EQ(visible(rig.ask("D")), "X+0000201<cr>Y-1294010<cr>Z+0000000<cr>T+0080000<cr>");
}

VXM_FORM("vxm.get.mode") { expect_get(form, "1", "setDM3", "3"); }

VXM_FORM("vxm.get.version") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("getD0"), "1.30\r");
}

VXM_FORM("vxm.get.date") {
  Rig rig = Rig::online();
  const std::string date = rig.ask("getD1");
  ASSERT_EQ(date.size(), 9u) << visible(date);
  EXPECT_EQ(date[2], '-');
  EXPECT_EQ(date[5], '-');
  EXPECT_EQ(date[8], '\r');
}

VXM_FORM("vxm.get.controllers") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("getD2"), "2\r");
  Rig four = Rig::online_with_slave();
  EXPECT_EQ(four.ask("getD2"), "4\r");
}

VXM_FORM("vxm.get.deadband") { expect_get(form, "40", "setDA55", "55"); }

VXM_FORM("vxm.get.jog1") {
  expect_get(form, "2000", "setj1M1000", "1000");
  expect_get_of_each_motor("j", "M", "123", "2000");
}
VXM_FORM("vxm.get.jog2") {
  expect_get(form, "2000", "setJ1M1000", "1000");
  expect_get_of_each_motor("J", "M", "123", "2000");
}
VXM_FORM("vxm.get.joy1") {
  expect_get(form, "0", "setjA1M24", "24");
  expect_get_of_each_motor("jA", "M", "3", "0");
}
VXM_FORM("vxm.get.joy2") {
  expect_get(form, "0", "setJA1M24", "24");
  expect_get_of_each_motor("JA", "M", "3", "0");
}
VXM_FORM("vxm.get.limit") {
  expect_get(form, "0", "setL1M-2", "-2");
  expect_get_of_each_motor("L", "M", "-1", "0");
}
VXM_FORM("vxm.get.motor") {
  expect_get(form, "0", "setM1M6", "6");
  expect_get_of_each_motor("M", "M", "4", "0");
}
VXM_FORM("vxm.get.pulse") {
  expect_get(form, "0", "setP1M32767", "32767");
  expect_get_of_each_motor("P", "M", "400", "0");
}
VXM_FORM("vxm.get.pulsewidth") { expect_get(form, "1", "setPA200", "200"); }
VXM_FORM("vxm.get.inputs") { expect_get(form, "7", "setI67", "67"); }

}  // namespace hw::vxm::proof
