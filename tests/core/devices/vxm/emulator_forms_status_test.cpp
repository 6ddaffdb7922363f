// Status requests that loop and compute (p.24, 25; App. A, D, E, F, H, I, J, N, O); the others: vxm.forms.
#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {
namespace {

std::string byte(int value) { return std::string(1, static_cast<char>(value)); }

}  // namespace

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

VXM_FORM("vxm.status.memory") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("M"), "256\r");
  rig.send("I1M400,");
  EXPECT_EQ(rig.ask("M"), "252\r");
  for (int i = 0; i < 63; ++i) rig.send("I1M400,");
  EXPECT_EQ(rig.ask("M"), "0\r") << "no padding (V22)";
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

VXM_FORM("vxm.get.date") {
  Rig rig = Rig::online();
  const std::string date = rig.ask("getD1");
  ASSERT_EQ(date.size(), 9u) << visible(date);
  EXPECT_EQ(date[2], '-');
  EXPECT_EQ(date[5], '-');
  EXPECT_EQ(date[8], '\r');
}

}  // namespace hw::vxm::proof
