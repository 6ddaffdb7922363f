// Pausing, inputs and outputs (p.22, App. B, D, G, H, T).
#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {
namespace {

// Levels are stable after 20 ms where contact bounce is filtered (V72).
constexpr Duration debounce = 20ms;

Rig running(const std::string& program) {
  Rig rig = Rig::online();
  rig.send(program + "R");
  return rig;
}

void expect_output(const std::string& on, const std::string& off, int number) {
  Rig rig = Rig::online();
  rig.run(on + ",");
  EXPECT_TRUE(rig.out(number));
  EXPECT_EQ(rig.ask("$"), std::string(1, static_cast<char>(1 << (number - 1))));
  rig.run(off + ",");
  EXPECT_FALSE(rig.out(number));
  rig.run(on + ",U5,");
  rig.run(off + ",");
  EXPECT_FALSE(rig.out(number));
}

// Both levels of an input; the program adds 1 step when the next command is not left out, 10 behind it.
void expect_skip(const std::string& form, int input, bool skipped_when_low) {
  for (const bool low : {false, true}) {
    Rig rig = Rig::online();
    rig.input(input, low);
    rig.run_for(10ms);
    rig.run(form + ",I1M1,I1M10,");
    EXPECT_EQ(rig.position(1), low == skipped_when_low ? 10 : 11) << form << (low ? " low" : " high");
  }
}

// A nonstop block of two indexes behind `start`, ended by U9.
const std::string nonstop = ",I1M1000,I1M500,U9,";

}  // namespace

VXM_FORM("vxm.pause.tenths") {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("P10,"), 1s));
  EXPECT_TRUE(same_time(rig.run("P0,"), 0s)) << "V81";
  EXPECT_TRUE(same_time(rig.run("P36000,"), 1h)) << "manual p.22";
  EXPECT_TRUE(same_time(rig.run("P65535,"), 6553500ms));
  expect_dropped(rig, "P65536");
  expect_dropped(rig, "P");
  EXPECT_FALSE(rig.out(1));
}

VXM_FORM("vxm.pause.ms10") {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("P-500,"), 50ms));
  EXPECT_TRUE(same_time(rig.run("P-1,"), 100us));
  EXPECT_TRUE(same_time(rig.run("P-65535,"), 6553500us));
  expect_dropped(rig, "P-65536");
  expect_dropped(rig, "P-0");
}

VXM_FORM("vxm.pause.out.tenths") {
  Rig rig = running("PA150,P1,");
  rig.run_for(14999ms);
  EXPECT_TRUE(rig.out(1));
  rig.run_for(2ms);
  EXPECT_FALSE(rig.out(1));
  rig.run_until_output("^");
  EXPECT_TRUE(same_time(rig.run("PA150,"), 15s));
  rig.run("U5,PA1,");
  EXPECT_TRUE(rig.out(1)) << "returns to the level that it had (V70)";
  expect_dropped(rig, "PA65536");
}

VXM_FORM("vxm.pause.out.pulse") {
  Rig rig = running("PA0,P1,");
  EXPECT_TRUE(rig.out(1));
  rig.run_for(9us);
  EXPECT_TRUE(rig.out(1));
  rig.run_for(2us);
  EXPECT_FALSE(rig.out(1));
  rig.run_until_output("^");
  EXPECT_TRUE(same_time(rig.run("PA0,"), 10us, 0s));
}

VXM_FORM("vxm.pause.out.ms10") {
  Rig rig = running("PA-150,P1,");
  rig.run_for(14900us);
  EXPECT_TRUE(rig.out(1));
  rig.run_for(200us);
  EXPECT_FALSE(rig.out(1));
  rig.run_until_output("^");
  EXPECT_TRUE(same_time(rig.run("PA-150,"), 15ms));
  expect_dropped(rig, "PA-65536");
}

VXM_FORM("vxm.u.0") {
  Rig rig = running("U0,I1M3,");
  rig.run_for(1h);
  EXPECT_TRUE(is_busy(rig));
  EXPECT_FALSE(rig.out(1));
  rig.input(1, true);
  rig.run_for(900us);
  rig.input(1, false);
  rig.run_for(1s);
  EXPECT_TRUE(is_busy(rig)) << "less than 1 ms is no low (V71)";
  rig.input(1, true);
  rig.run_for(1100us);
  EXPECT_TRUE(rig.run_until_output("^", 1s));
  EXPECT_EQ(rig.position(1), 3);
  EXPECT_LE(rig.run("U0,"), 1ms) << "already low at the start is fine";
}

VXM_FORM("vxm.u.1") {
  Rig rig = running("U1,P1,");
  rig.run_for(1s);
  EXPECT_TRUE(rig.out(1)) << "output 1 high meanwhile";
  rig.input(1, true);
  rig.run_for(1100us);
  EXPECT_FALSE(rig.out(1));
  EXPECT_TRUE(rig.run_until_output("^", 1s));
}

VXM_FORM("vxm.u.2") {
  Rig rig = running("U2,U0,");
  rig.click("1+");
  rig.click("2-");
  EXPECT_EQ(rig.position(1), 1) << "jogging by hand while it waits";
  EXPECT_EQ(rig.position(2), -1);
  rig.pulse_input(1);
  EXPECT_TRUE(rig.run_until_output("^", 1s));
}

VXM_FORM("vxm.u.3") {
  Rig rig = running("U2,U3,U0,");
  rig.click("1+");
  EXPECT_EQ(rig.position(1), 0);
  rig.send("K");
  Rig fresh = running("U0,");
  fresh.click("1+");
  EXPECT_EQ(fresh.position(1), 0) << "the state at power-up";
}

VXM_FORM("vxm.u.4") { expect_output("U5", "U4", 1); }
VXM_FORM("vxm.u.5") { expect_output("U5", "U4", 1); }
VXM_FORM("vxm.u.14") { expect_output("U15", "U14", 2); }
VXM_FORM("vxm.u.15") { expect_output("U15", "U14", 2); }
VXM_FORM("vxm.u.16") { expect_output("U17", "U16", 3); }
VXM_FORM("vxm.u.17") { expect_output("U17", "U16", 3); }
VXM_FORM("vxm.u.18") { expect_output("U19", "U18", 4); }
VXM_FORM("vxm.u.19") { expect_output("U19", "U18", 4); }

VXM_FORM("vxm.u.6") {
  Rig rig = Rig::online();
  EXPECT_EQ(rig.ask("U6,I1M3,R"), "W");
  rig.run_for(1h);
  EXPECT_EQ(rig.ask("V"), "B");
  EXPECT_EQ(rig.ask("X"), "+0000000\r");
  EXPECT_EQ(rig.ask("D"), "") << "does not release it (V79)";
  rig.run_for(1s);
  EXPECT_TRUE(is_busy(rig));
  rig.send("G");
  EXPECT_TRUE(rig.run_until_output("^"));
  EXPECT_EQ(rig.position(1), 3);
  rig.output();
  rig.send("G");
  EXPECT_EQ(rig.ask("R"), "W\r") << "in G mode";
  EXPECT_EQ(rig.ask("K"), "^\r");
}

VXM_FORM("vxm.u.7") {
  Rig rig = Rig::online();
  // Manual p.39: pulses at 1000, 1100, 1150, 1250, then back to the start.
  rig.run("S1M1500,U7,I1M1000,I1M100,I1M50,I1M100,U9,IA1M0,");
  EXPECT_EQ(rig.pulse_positions(1), (std::vector<std::int64_t>{1000, 1100, 1150, 1250}));
  EXPECT_EQ(rig.position(1), 0);
  ASSERT_FALSE(rig.pulses().empty());
  EXPECT_EQ(rig.pulses()[0].width, 10us);
}

VXM_FORM("vxm.u.77") {
  Rig rig = Rig::online();
  const Duration took = rig.run("U77" + nonstop);
  // 1 s of ramp over 1000 steps, 500 steps at 2000 steps/s, 1 s of ramp.
  EXPECT_TRUE(same_time(took, 2250ms));
  EXPECT_EQ(rig.position(1), 2500);
  EXPECT_TRUE(rig.pulses().empty()) << "no signal";
}

VXM_FORM("vxm.u.8") {
  Rig rig = Rig::online();
  rig.send("U8" + nonstop + "R");
  rig.run_for(999ms);
  EXPECT_EQ(rig.output(), "");
  rig.run_for(2ms);
  EXPECT_EQ(rig.output(), "@") << "at the end of the first index";
  rig.run_until_output("^");
  EXPECT_EQ(rig.output(), "@^") << "the last one signals too";
  EXPECT_TRUE(rig.pulses().empty());
  rig.send("GR");
  rig.run_until_output("^\r");
  EXPECT_EQ(visible(rig.output()), "@@^<cr>") << "no <cr> in G mode (V78)";
}

VXM_FORM("vxm.u.9") {
  Rig rig = Rig::online();
  rig.run("S1M1000,U77,I1M1000,U9,");
  EXPECT_EQ(rig.position(1), 1250) << "v2/2a behind the last index (V76)";
}

VXM_FORM("vxm.u.91") {
  Rig rig = Rig::online();
  rig.run("S1M1000,U77,I1M1000,U91,");
  EXPECT_EQ(rig.position(1), 1250);
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M241<cr>S1M1000<cr>U77<cr>I1M1000<cr>U92<cr>I1M250<cr>");
  EXPECT_EQ(rig.free_bytes(), 241) << "six bytes before and after";
  rig.run_program();
  EXPECT_EQ(rig.position(1), 2500) << "the same with its own index";
  rig.send("del");
  EXPECT_EQ(visible(rig.ask("lst")), "PM0 M245<cr>S1M1000<cr>U77<cr>I1M1000<cr>U92<cr>") << "V36";
}

VXM_FORM("vxm.u.92") {
  Rig rig = Rig::online();
  const Duration took = rig.run("S1M1000,U77,I1M1000,U92,I1M500,I2M4,");
  EXPECT_EQ(rig.position(1), 1500) << "stops after exactly that index (V77)";
  // 0.5 s of ramp over 250 steps, 750 at 1000 steps/s, 500 steps of constant slowing take 1 s.
  EXPECT_TRUE(same_time(took, 500ms + 750ms + 1s + index_time(4)));
  EXPECT_EQ(rig.position(2), 4);
  rig.send("C");
  rig.send("U77,I1M100,U92,P1,R");
  EXPECT_TRUE(rig.run_until_output("EC", 10s)) << "without an index behind it";
}

VXM_FORM("vxm.u.99") {
  Rig rig = Rig::online();
  EXPECT_TRUE(same_time(rig.run("S1M500,U77,I1M1000,U99,"), from_seconds(0.25 + (1000 - 62.5) / 500)));
  EXPECT_EQ(rig.position(1), 1000) << "no ramp behind the last index";
}

VXM_FORM("vxm.u.11") { expect_skip("U11", 1, false); }
VXM_FORM("vxm.u.12") { expect_skip("U12", 2, false); }
VXM_FORM("vxm.u.21") { expect_skip("U21", 1, true); }
VXM_FORM("vxm.u.22") { expect_skip("U22", 2, true); }

VXM_FORM("vxm.u.13") {
  struct Choice {
    const char* button;
    std::int64_t ends_at;
  };
  for (const Choice& c : {Choice{"1-", 100}, Choice{"1+", 20}, Choice{"Run", 3}}) {
    Rig rig = Rig::online();
    rig.send("PM1,I1M100,PM2,I1M20,PM0,U13,I1M3,R");
    rig.run_for(10s);
    EXPECT_TRUE(is_busy(rig));
    rig.click(c.button);
    EXPECT_TRUE(rig.run_until_output("^", 5s)) << c.button;
    EXPECT_EQ(rig.position(1), c.ends_at) << c.button << ": without coming back";
  }
}

VXM_FORM("vxm.u.23") {
  struct Choice {
    const char* button;
    std::int64_t ends_at;
  };
  for (const Choice& c : {Choice{"1-", 103}, Choice{"1+", 23}, Choice{"Run", 3}}) {
    Rig rig = Rig::online();
    rig.send("PM1,I1M100,PM2,I1M20,PM0,U23,I1M3,R");
    rig.run_for(10s);
    rig.click(c.button);
    EXPECT_TRUE(rig.run_until_output("^", 5s)) << c.button;
    EXPECT_EQ(rig.position(1), c.ends_at) << c.button << ": and back";
  }
}

VXM_FORM("vxm.u.30") {
  Rig rig = running("U30,");
  rig.run_for(1s);
  EXPECT_TRUE(is_busy(rig));
  rig.input(1, true);
  rig.run_for(1s);
  EXPECT_TRUE(is_busy(rig)) << "low is not enough";
  rig.input(1, false);
  rig.run_for(900us);
  EXPECT_TRUE(is_busy(rig)) << "high for 1 ms";
  rig.run_for(200us);
  EXPECT_EQ(rig.output(), "^");
}

VXM_FORM("vxm.u.31") {
  Rig rig = running("U31,P1,");
  rig.run_for(1s);
  EXPECT_TRUE(rig.out(1));
  rig.input(1, true);
  rig.run_for(2ms);
  EXPECT_TRUE(rig.out(1));
  rig.input(1, false);
  rig.run_for(1100us);
  EXPECT_FALSE(rig.out(1));
  EXPECT_TRUE(rig.run_until_output("^", 1s));
}

VXM_FORM("vxm.u.32") {
  Rig rig = running("U32,");
  rig.click("1+");
  EXPECT_TRUE(is_busy(rig)) << "another button";
  rig.press("1-");
  rig.run_for(5ms);
  rig.release("1-");
  rig.run_for(1s);
  EXPECT_TRUE(is_busy(rig)) << "contact bounce";
  rig.press("1-");
  rig.run_for(debounce + 1ms);
  EXPECT_EQ(rig.output(), "^") << "on the press";
  EXPECT_EQ(rig.position(1), 0) << "no jog";
}

VXM_FORM("vxm.u.33") {
  Rig rig = running("U33,");
  rig.click("1-");
  EXPECT_TRUE(is_busy(rig));
  rig.press("1+");
  rig.run_for(debounce + 1ms);
  EXPECT_EQ(rig.output(), "^");
}

VXM_FORM("vxm.u.50") {
  Rig rig = running("U50,");
  for (int bounce = 0; bounce < 10; ++bounce) rig.pulse_input(1, 5ms);
  EXPECT_TRUE(is_busy(rig)) << "contact bounce is no press";
  rig.input(1, true);
  rig.run_for(1s);
  EXPECT_TRUE(is_busy(rig)) << "a press without its release";
  rig.input(1, false);
  rig.run_for(debounce - 1ms);
  EXPECT_TRUE(is_busy(rig));
  rig.run_for(2ms);
  EXPECT_EQ(rig.output(), "^");
}

VXM_FORM("vxm.u.51") {
  Rig rig = running("U51,P1,");
  rig.run_for(1s);
  EXPECT_TRUE(rig.out(1));
  rig.pulse_input(1, 5ms);
  EXPECT_TRUE(rig.out(1));
  rig.pulse_input(1, 25ms);
  EXPECT_FALSE(rig.out(1));
  EXPECT_TRUE(rig.run_until_output("^", 1s));
}

VXM_FORM("vxm.u.90") {
  Rig rig = running("U90,I1M3,");
  rig.press("Run");
  rig.run_for(1s);
  EXPECT_TRUE(is_busy(rig));
  EXPECT_EQ(rig.position(1), 0);
  rig.release("Run");
  EXPECT_TRUE(rig.run_until_output("^", 1s));
  EXPECT_EQ(rig.position(1), 3);
  rig.run_for(10s);
  EXPECT_EQ(rig.output(), "") << "the release starts no run of its own";
}

}  // namespace hw::vxm::proof
