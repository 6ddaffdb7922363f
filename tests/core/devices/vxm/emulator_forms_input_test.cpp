// Forms of pausing, inputs and outputs that loop and compute (p.22, App. B, D, G, H, T); the others:
// vxm.forms.
#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {
namespace {

// Levels are stable after 20 ms where contact bounce is filtered (V72).
constexpr Duration debounce = 20ms;

Rig on_the_bus(const std::string& program) {
  Rig rig = Rig::online_with_slave();
  rig.send(program + "R");
  return rig;
}

// A nonstop block of two indexes behind `start`, ended by U9.
const std::string nonstop = ",I1M1000,I1M500,U9,";

}  // namespace

VXM_FORM("vxm.u.113") {
  const std::string programs = "PM1,I1M100,PM2,I1M20,PM0,U113,I1M3,";
  for (const auto& [button, ends_at] : {std::pair{"3-", 100}, {"3+", 20}, {"Slave Run", 3}}) {
    Rig rig = on_the_bus(programs);
    rig.click("1-");
    rig.click("1+");
    EXPECT_TRUE(is_busy(rig)) << "not the Master's buttons";
    rig.click(button);
    EXPECT_TRUE(rig.run_until_output("^", 5s)) << button;
    EXPECT_EQ(rig.position(1), ends_at) << button << ": the Master's programs (V98)";
  }
  expect_bus_error(form);
}

VXM_FORM("vxm.u.123") {
  const std::string programs = "PM1,I1M100,PM2,I1M20,PM0,U123,I1M3,";
  for (const auto& [button, ends_at] : {std::pair{"3-", 103}, {"3+", 23}, {"Slave Run", 3}}) {
    Rig rig = on_the_bus(programs);
    rig.click(button);
    EXPECT_TRUE(rig.run_until_output("^", 5s)) << button;
    EXPECT_EQ(rig.position(1), ends_at) << button;
  }
  expect_bus_error(form);
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

}  // namespace hw::vxm::proof
