// Two controllers on the bus: ( ), [ ] and the Slave's inputs and outputs (App. B p.37, App. G).
#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {
namespace {

constexpr int slave_input_1 = 5, slave_output_1 = 5;

Rig on_the_bus(const std::string& program) {
  Rig rig = Rig::online_with_slave();
  rig.send(program + "R");
  return rig;
}

// Alone on the bus: entered without a complaint, the error comes when it is run (V95).
void expect_bus_error(const Form& form) {
  Rig lone = Rig::online();
  EXPECT_EQ(lone.ask(form.example + ","), "");
  EXPECT_EQ(lone.used_bytes(), form.bytes());
  lone.send("R");
  lone.run_for(1s);
  EXPECT_EQ(lone.output(), "EB");
  EXPECT_EQ(lone.ask("V"), "J") << "it resets";
}

void expect_output(const Form& form, const std::string& on, const std::string& off, int number) {
  Rig rig = Rig::online_with_slave();
  rig.run(on + ",");
  EXPECT_TRUE(rig.out(number));
  EXPECT_EQ(rig.view().outputs, 1u << (number - 1)) << "none of the Master's";
  rig.run(off + ",");
  EXPECT_FALSE(rig.out(number));
  expect_bus_error(form);
}

}  // namespace

VXM_FORM("vxm.bus.combine") {
  Rig rig = Rig::online_with_slave();
  EXPECT_TRUE(same_time(rig.run("(I3M800,I1M400,)"), index_time(800)));
  EXPECT_EQ(rig.position(1), 400);
  EXPECT_EQ(rig.position(3), 800);
  EXPECT_TRUE(same_time(rig.run("(I1M400,I3M800,)"), index_time(800) + index_time(400)))
      << "the wrong order: not at the same time (p.47)";
  EXPECT_EQ(rig.position(1), 800);
  EXPECT_EQ(rig.position(3), 1600);
  EXPECT_TRUE(same_time(rig.run("I1M400,I3M800,"), index_time(800) + index_time(400)));
}

VXM_FORM("vxm.bus.slave") {
  Rig rig = Rig::online_with_slave();
  EXPECT_EQ(rig.ask("[I1M400,]"), "");
  EXPECT_EQ(rig.used_bytes(), 0) << "nothing in the Master (V99)";
  rig.run("I2M3,");
  EXPECT_EQ(rig.position(3), 0) << "not run by R alone";
  rig.send("PMA0,");
  rig.run_program();
  EXPECT_EQ(rig.position(3), 400) << "the Slave's program 0";
  EXPECT_EQ(rig.ask("[R,Q,X,V,]"), "") << "R, Q and status requests are dropped";
  EXPECT_EQ(rig.position(3), 400);
  EXPECT_EQ(rig.ask("V"), "R");
  rig.send("Q[C]F");
  rig.run_program();
  EXPECT_EQ(rig.position(3), 800) << "dropped in local mode";
  rig.send("CP1,R[C]");
  rig.run_until_output("^");
  rig.run_program();
  EXPECT_EQ(rig.position(3), 1600) << "and while a program runs: the Slave's own ran both times";
  Rig lone = Rig::online();
  lone.send("[I1M400,]");
  EXPECT_EQ(lone.output(), "EB") << "no Slave (V95)";
}

VXM_FORM("vxm.u.100") {
  Rig rig = on_the_bus("U100,");
  rig.input(1, true);
  rig.run_for(1s);
  EXPECT_TRUE(is_busy(rig)) << "not the Master's input";
  rig.input(slave_input_1, true);
  rig.run_for(5ms);
  EXPECT_EQ(rig.output(), "^");
  expect_bus_error(form);
}

VXM_FORM("vxm.u.101") {
  Rig rig = on_the_bus("U101,P1,");
  rig.run_for(1s);
  EXPECT_TRUE(rig.out(slave_output_1));
  EXPECT_FALSE(rig.out(1));
  rig.input(slave_input_1, true);
  rig.run_for(5ms);
  EXPECT_FALSE(rig.out(slave_output_1));
  expect_bus_error(form);
}

VXM_FORM("vxm.u.102") {
  Rig rig = on_the_bus("U102,U100,");
  rig.click("3+");
  rig.input(slave_input_1, true);
  EXPECT_TRUE(rig.run_until_output("^", 1s));
  EXPECT_EQ(rig.position(3), 1) << "the Slave jogs while the Slave waits";
  expect_bus_error(form);
}

VXM_FORM("vxm.u.103") {
  Rig rig = on_the_bus("U102,U103,U100,");
  rig.click("3+");
  rig.input(slave_input_1, true);
  EXPECT_TRUE(rig.run_until_output("^", 1s));
  EXPECT_EQ(rig.position(3), 0);
  expect_bus_error(form);
}

VXM_FORM("vxm.u.104") { expect_output(form, "U105", "U104", 5); }
VXM_FORM("vxm.u.105") { expect_output(form, "U105", "U104", 5); }
VXM_FORM("vxm.u.114") { expect_output(form, "U115", "U114", 6); }
VXM_FORM("vxm.u.115") { expect_output(form, "U115", "U114", 6); }
VXM_FORM("vxm.u.116") { expect_output(form, "U117", "U116", 7); }
VXM_FORM("vxm.u.117") { expect_output(form, "U117", "U116", 7); }
VXM_FORM("vxm.u.118") { expect_output(form, "U119", "U118", 8); }
VXM_FORM("vxm.u.119") { expect_output(form, "U119", "U118", 8); }

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

VXM_FORM("vxm.u.130") {
  Rig rig = on_the_bus("U130,");
  rig.pulse_input(1);
  EXPECT_TRUE(is_busy(rig));
  rig.input(slave_input_1, true);
  rig.run_for(1s);
  EXPECT_TRUE(is_busy(rig));
  rig.input(slave_input_1, false);
  rig.run_for(5ms);
  EXPECT_EQ(rig.output(), "^");
  expect_bus_error(form);
}

VXM_FORM("vxm.u.131") {
  Rig rig = on_the_bus("U131,P1,");
  rig.run_for(1s);
  EXPECT_TRUE(rig.out(slave_output_1));
  rig.pulse_input(slave_input_1);
  EXPECT_FALSE(rig.out(slave_output_1));
  EXPECT_TRUE(rig.run_until_output("^", 1s));
  expect_bus_error(form);
}

VXM_FORM("vxm.u.132") {
  Rig rig = on_the_bus("U132,");
  rig.click("1-");
  rig.click("3+");
  EXPECT_TRUE(is_busy(rig));
  rig.click("3-");
  EXPECT_EQ(rig.output(), "^");
  expect_bus_error(form);
}

VXM_FORM("vxm.u.133") {
  Rig rig = on_the_bus("U133,");
  rig.click("1+");
  EXPECT_TRUE(is_busy(rig));
  rig.click("3+");
  EXPECT_EQ(rig.output(), "^");
  expect_bus_error(form);
}

VXM_FORM("vxm.u.150") {
  Rig rig = on_the_bus("U150,");
  rig.pulse_input(slave_input_1, 5ms);
  EXPECT_TRUE(is_busy(rig)) << "contact bounce";
  rig.pulse_input(slave_input_1);
  EXPECT_EQ(rig.output(), "^");
  expect_bus_error(form);
}

VXM_FORM("vxm.u.151") {
  Rig rig = on_the_bus("U151,P1,");
  rig.run_for(1s);
  EXPECT_TRUE(rig.out(slave_output_1));
  rig.pulse_input(slave_input_1);
  EXPECT_FALSE(rig.out(slave_output_1));
  EXPECT_TRUE(rig.run_until_output("^", 1s));
  expect_bus_error(form);
}

VXM_FORM("vxm.u.190") {
  Rig rig = on_the_bus("U190,I1M3,");
  rig.click("Run");
  EXPECT_TRUE(is_busy(rig)) << "not the Master's button";
  rig.click("Slave Run");
  EXPECT_TRUE(rig.run_until_output("^", 1s));
  EXPECT_EQ(rig.position(1), 3);
  expect_bus_error(form);
}

}  // namespace hw::vxm::proof
