// Motor commands (manual p.16 to 18).
#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {
namespace {

// The highest and lowest value are stored; beyond them the command is dropped (V09), as without one (V10).
void expect_range(const std::string& head, const std::string& lowest, const std::string& highest,
                  const std::vector<std::string>& beyond, int bytes) {
  Rig rig = Rig::online();
  rig.send(head + lowest + ",");
  EXPECT_EQ(rig.used_bytes(), bytes) << head << lowest;
  rig.send(head + highest + ",");
  EXPECT_EQ(rig.used_bytes(), 2 * bytes) << head << highest;
  for (const std::string& value : beyond) expect_dropped(rig, head + value);
}

// A short form means the motor named last.
void expect_short(const std::string& after, const std::string& shortcut, const std::string& listed) {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("#"), "1\r");
  rig.send(after + ",C");
  EXPECT_EQ(rig.ask("#"), "2\r");
  rig.send(shortcut + ",");
  const std::string list = rig.ask("lst");
  EXPECT_NE(list.find("\r" + listed + "\r"), std::string::npos) << visible(list);
}

}  // namespace

VXM_FORM("vxm.index.inc.pos") {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("I1M1200,"), index_time(1200)));
  EXPECT_EQ(rig.ask("X"), "+0001200\r");
  EXPECT_TRUE(same_time(rig.run_program(), index_time(1200))) << "relative: again from there";
  EXPECT_EQ(rig.position(1), 2400);
  EXPECT_EQ(rig.load(1), 2400);
  expect_range("I1M", "1", "16777215", {"16777216", "99999999999999999999", ""}, 4);
  expect_range("I4M", "1", "16777215", {}, 4);
  expect_dropped(rig, "I5M400");
}

VXM_FORM("vxm.index.inc.neg") {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("I2M-600,"), index_time(600)));
  EXPECT_EQ(rig.ask("Y"), "-0000600\r");
  EXPECT_EQ(rig.ask("X"), "+0000000\r");
  expect_range("I2M-", "1", "16777215", {"16777216", ""}, 4);
}

VXM_FORM("vxm.index.abs.pos") {
  Rig rig = Rig::online();
  rig.run("I1M500,");
  EXPECT_TRUE(same_time(rig.run("IA1M1200,"), index_time(700))) << "from where it stands";
  EXPECT_EQ(rig.position(1), 1200);
  EXPECT_TRUE(same_time(rig.run_program(), 0s)) << "already there (V66)";
  expect_range("IA1M", "1", "8388607", {"8388608", "16777215", ""}, 4);
}

VXM_FORM("vxm.index.abs.neg") {
  Rig rig = Rig::online_with_slave();
  EXPECT_TRUE(same_time(rig.run("IA4M-90200,"), index_time(90200)));
  EXPECT_EQ(rig.ask("T"), "-0090200\r");
  expect_range("IA4M-", "1", "8388608", {"8388609", ""}, 4);
}

VXM_FORM("vxm.index.abs.zero") {
  Rig rig = Rig::online();
  rig.run("I2M-321,");
  EXPECT_TRUE(same_time(rig.run("IA2M0,"), index_time(321)));
  EXPECT_EQ(rig.position(2), 0);
}

VXM_FORM("vxm.index.setzero") {
  Rig rig = Rig::online();
  rig.run("I1M400,I2M30,");
  EXPECT_TRUE(same_time(rig.run("IA1M-0,"), 0s));
  EXPECT_EQ(rig.position(1), 0);
  EXPECT_EQ(rig.position(2), 30) << "only the motor named";
  EXPECT_EQ(rig.load(1), 400) << "nothing moved";
}

VXM_FORM("vxm.index.home.pos") {
  Rig rig = Rig::online();
  AxisPlace travel;
  travel.plus = Steps(1000);
  rig.place(1, travel);
  EXPECT_TRUE(same_time(rig.run("I1M0,"), 1s)) << "1000 steps of ramp at 2000 steps/s2, stopped hard";
  EXPECT_EQ(rig.position(1), 1000);
  EXPECT_TRUE(same_time(rig.run_program(), 0s)) << "switch already active: no motion (V63)";
  EXPECT_EQ(rig.position(1), 1000);

  Rig endless = Rig::online();
  const Duration took = endless.run("S1M6000,I1M0,");
  EXPECT_NEAR(seconds(took), 16e6 / 6000, 10) << "gives up (V63)";
  EXPECT_EQ(endless.load(1), 16'000'000);
}

VXM_FORM("vxm.index.home.neg") {
  Rig rig = Rig::online();
  AxisPlace travel;
  travel.minus = Steps(-250);
  rig.place(1, travel);
  EXPECT_TRUE(same_time(rig.run("I1M-0,"), 500ms));
  EXPECT_EQ(rig.position(1), -250);
  rig.run("I1M300,I1M-0,");
  EXPECT_EQ(rig.position(1), -250) << "the same place each time";
}

VXM_FORM("vxm.speed.70") {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("S1M500,I1M400,"), index_time(400, 500)));
  EXPECT_TRUE(same_time(rig.run("I1M400,"), index_time(400, 500))) << "lasts until changed (V57)";
  EXPECT_TRUE(same_time(rig.run("I2M400,"), index_time(400))) << "motor 2 has its own";
  expect_range("S1M", "1", "6000", {"0", "6001", ""}, 3);
  rig.send("res");
  rig.run_for(10s);
  rig.send("F");
  EXPECT_TRUE(same_time(rig.run("I1M400,"), index_time(400))) << "2000 again after res";
}

VXM_FORM("vxm.speed.100") {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("SA2M3000,I2M9000,"), index_time(9000, 3000)));
  EXPECT_EQ(rig.position(2), 9000);
  expect_range("SA2M", "1", "6000", {"0", "6001", ""}, 3);
}

VXM_FORM("vxm.speed.analog.70") {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("S1M-12,I1M4000,"), index_time(4000, 2000))) << "512: half way";
  rig.analog(1, 1024);
  EXPECT_TRUE(same_time(rig.run_program(), index_time(4000, 3000)));
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M249<cr>S1M3000<cr>I1M4000<cr>") << "the derived speed (App. I)";
  rig.analog(1, 0);
  EXPECT_TRUE(same_time(rig.run_program(), index_time(4000, 1000)));
  EXPECT_TRUE(same_time(rig.run("S1M-1,I1M3,"), index_time(3, 1))) << "at least 1 step/s";
  rig.send("C");
  for (const char* range : {"0", "7", "10", "16", "25", "34", "43", "52", "100"})
    expect_dropped(rig, std::string("S1M-") + range);
}

VXM_FORM("vxm.speed.analog.100") {
  Rig rig = Rig::online();
  rig.analog(1, 256);
  EXPECT_TRUE(same_time(rig.run("SA1M-12,I1M4000,"), index_time(4000, 1500)));
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M249<cr>SA1M1500<cr>I1M4000<cr>");
  for (const char* range : {"1",  "2",  "3",  "4",  "5",  "6",  "11", "12", "13", "14", "15",
                            "21", "22", "23", "24", "31", "32", "33", "41", "42", "51"}) {
    rig.send("C");
    rig.send(std::string("SA1M-") + range + ",");
    EXPECT_EQ(rig.used_bytes(), 3) << range;
  }
}

VXM_FORM("vxm.accel") {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("A1M3,I1M400,"), index_time(400, 2000, 3)));
  EXPECT_TRUE(same_time(rig.run("I2M400,"), index_time(400, 2000, 2))) << "motor 2 has its own";
  EXPECT_TRUE(same_time(rig.run("A1M127,I1M4000,"), index_time(4000, 2000, 127)));
  expect_range("A1M", "1", "127", {"0", "128", ""}, 2);
}

VXM_FORM("vxm.short.index.inc.pos") { expect_short("S2M1000", "I400", "I2M400"); }
VXM_FORM("vxm.short.index.inc.neg") { expect_short("A2M4", "I-200", "I2M-200"); }
VXM_FORM("vxm.short.index.abs.pos") { expect_short("I2M1", "IA400", "IA2M400"); }
VXM_FORM("vxm.short.index.abs.neg") { expect_short("IA2M0", "IA-400", "IA2M-400"); }
VXM_FORM("vxm.short.index.abs.zero") { expect_short("SA2M5", "IA0", "IA2M0"); }
VXM_FORM("vxm.short.index.setzero") { expect_short("I2M-1", "IA-0", "IA2M-0"); }
VXM_FORM("vxm.short.index.home.pos") { expect_short("I2M1", "I0", "I2M0"); }
VXM_FORM("vxm.short.index.home.neg") { expect_short("I2M1", "I-0", "I2M-0"); }
VXM_FORM("vxm.short.speed.70") { expect_short("I2M1", "S4000", "S2M4000"); }
VXM_FORM("vxm.short.speed.100") { expect_short("I2M1", "SA3000", "SA2M3000"); }
VXM_FORM("vxm.short.speed.analog.70") { expect_short("I2M1", "S-12", "S2M2000"); }
VXM_FORM("vxm.short.speed.analog.100") { expect_short("I2M1", "SA-12", "SA2M2000"); }

VXM_FORM("vxm.short.accel") {
  expect_short("I2M1", "A2", "A2M2");
  // The manual's two samples, p.18.
  Rig one = Rig::online();
  EXPECT_TRUE(same_time(one.run("A2,S4000,I400,"), index_time(400, 4000)));
  EXPECT_EQ(one.position(1), 400);
  Rig two = Rig::online();
  two.run("I2M200,I-200,S2000,IA0,");
  EXPECT_EQ(visible(two.ask("lst")), "PM0 M241<cr>I2M200<cr>I2M-200<cr>S2M2000<cr>IA2M0<cr>");
  EXPECT_EQ(two.position(2), 0);
}

}  // namespace hw::vxm::proof
