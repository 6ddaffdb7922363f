// Rows of the registers and their bits.
// Those that neither loop nor compute stand in vme58.forms.
#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

/// The offset of the row is that of the register, and a byte.
void expect_place(const Form& f, std::uint16_t offset) {
  const std::string at = std::to_string(offset);
  EXPECT_EQ(f.arg("offset"), at + ".." + at);
  EXPECT_EQ(f.arg("bytes"), "1");
  EXPECT_NE(f.example.find("0x0F"), std::string::npos);
}

void expect_read_only(Rig& rig, std::uint16_t offset) {
  const auto before = rig.read8(offset);
  rig.write8(offset, static_cast<std::uint8_t>(~before));
  EXPECT_EQ(rig.read8(offset), before);
}

/// Something that makes the board interrupt by one bit of the control register.
void expect_interrupt_by(std::uint8_t enable, void (*cause)(Rig&)) {
  Rig rig = Rig::model("4E");
  rig.write8(reg::vector, 0xB4);
  cause(rig);
  EXPECT_FALSE(rig.bus().interrupt()) << "not enabled";
  EXPECT_EQ(rig.status() & status::interrupt, 0);

  Rig gated = Rig::model("4E");
  gated.write8(reg::control, enable);
  cause(gated);
  EXPECT_FALSE(gated.bus().interrupt()) << "bit 7 gates it";

  Rig enabled = Rig::model("4E");
  enabled.write8(reg::vector, 0xB4);
  enabled.write8(reg::control, enable | control::interrupts);
  EXPECT_FALSE(enabled.bus().interrupt());
  cause(enabled);
  ASSERT_TRUE(enabled.bus().interrupt());
  EXPECT_EQ(*enabled.bus().interrupt(), 0xB4);
  enabled.bus().acknowledge();
  EXPECT_FALSE(enabled.bus().interrupt());
  EXPECT_NE(enabled.status() & status::interrupt, 0) << "bit 7 stays until it is read";
  EXPECT_EQ(enabled.status() & status::interrupt, 0);
}

void raise_done(Rig& rig) { rig.send("AX ID "); }

void meet_limit(Rig& rig) {
  rig.send("AX JG1000 ");
  rig.run_for(1s);
  rig.limit('X', '+', true);
}

void pull_input_0(Rig& rig) { rig.line(0, true); }

void slip_with_is(Rig& rig) {
  rig.send("AX ES10 IS ");
  rig.operate(bench::Jam(AxisId{0}, true));
  rig.send("MR1000 GO ");
  rig.run_for(1s);
}

}  // namespace

// --- registers ---------------------------------------------------------------------------------------------

VME58_FORM("vme58.reg.control") {
  expect_place(form, reg::control);
  Rig rig;
  EXPECT_EQ(rig.read8(reg::control), 0);
  rig.write8(reg::control, 0x90);
  EXPECT_EQ(rig.read8(reg::control), 0x90);
  rig.send("AX RS");
  rig.run_for(200ms);
  EXPECT_EQ(rig.read8(reg::control), 0);
}

TEST(Vme58Interrupt, ADoneFlagThatIsStillSetInterruptsAgain) {
  Rig rig;
  rig.write8(reg::control, control::interrupts | control::done_interrupt);
  rig.send("AX ID ");
  EXPECT_EQ(rig.status(), status::interrupt | status::done | status::initialized);
  EXPECT_EQ(rig.status(), status::done | status::initialized) << "reading takes it away";
  rig.send("AX ID ");
  EXPECT_EQ(rig.status(), status::interrupt | status::done | status::initialized);
}

VME58_FORM("vme58.reg.status") {
  expect_place(form, reg::status);
  Rig rig;
  EXPECT_EQ(rig.status(), status::initialized) << "a served emulator is ready when it says so";
  rig.send("XX AY ID ");
  EXPECT_EQ(rig.status(), status::command_error | status::initialized | status::done);
  EXPECT_EQ(rig.status(), status::initialized | status::done) << "reading clears the command error alone";
  rig.done();
  expect_read_only(rig, reg::status);
}

VME58_FORM("vme58.reg.io_low") {
  expect_place(form, reg::io_low);
  Rig rig;
  EXPECT_EQ(rig.read8(reg::io_low), 0xFF) << "inputs are pulled up";
  rig.line(0, true);
  rig.line(5, true);
  EXPECT_EQ(rig.read8(reg::io_low), 0xDE);
  rig.line(0, false);
  EXPECT_EQ(rig.read8(reg::io_low), 0xDF);
  expect_read_only(rig, reg::io_low);
}

VME58_FORM("vme58.reg.io_high") {
  expect_place(form, reg::io_high);
  Rig rig;
  EXPECT_EQ(rig.read8(reg::io_high), 0x3F);
  rig.send("BL8 BL13 ");
  EXPECT_EQ(rig.read8(reg::io_high), 0x1E);
  rig.send("BH13 ");
  EXPECT_EQ(rig.read8(reg::io_high), 0x3E);
  expect_read_only(rig, reg::io_high);
}

VME58_FORM("vme58.reg.slip") {
  expect_place(form, reg::slip);
  Rig rig = Rig::model("4E");
  EXPECT_EQ(rig.read8(reg::slip), 0);
  rig.send("AT ES10 ");
  rig.operate(bench::Jam(AxisId{3}, true));
  rig.send("MR1000 GO ");
  rig.run_for(1s);
  EXPECT_NE(rig.status() & status::slip, 0);
  EXPECT_EQ(rig.read8(reg::slip), bit_of('T'));
  EXPECT_EQ(rig.read8(reg::slip), 0) << "reading clears";
  EXPECT_EQ(rig.status() & status::slip, 0);
}

VME58_FORM("vme58.reg.done") {
  expect_place(form, reg::done);
  Rig rig;
  EXPECT_EQ(rig.done(), 0);
  for (const char letter : axis_letters) {
    rig.send(std::string("A") + letter + " ID ");
    EXPECT_EQ(rig.done(), bit_of(letter));
    EXPECT_EQ(rig.done(), 0) << "reading clears";
  }
  rig.send("AX ID AS ID ");
  EXPECT_EQ(rig.read16(reg::done - 1), bit_of('X') | bit_of('S')) << "as the low byte of a cell";
  expect_read_only(rig, reg::done);
}

VME58_FORM("vme58.reg.limit") {
  expect_place(form, reg::limit);
  Rig rig;
  EXPECT_EQ(rig.read8(reg::limit), 0);
  rig.limit('Z', '-', true);
  EXPECT_EQ(rig.read8(reg::limit), bit_of('Z')) << "either end, also at rest";
  rig.limit('Z', '-', false);
  EXPECT_EQ(rig.read8(reg::limit), 0);
  rig.send("AY JG1000 ");
  rig.run_for(1s);
  rig.limit('Y', '+', true);
  rig.limit('Y', '+', false);
  EXPECT_EQ(rig.read8(reg::limit), bit_of('Y')) << "a hit stays until it is read";
  EXPECT_EQ(rig.read8(reg::limit), 0);
  expect_read_only(rig, reg::limit);
}

VME58_FORM("vme58.reg.home") {
  expect_place(form, reg::home);
  Rig rig;
  EXPECT_EQ(rig.read8(reg::home), 0);
  rig.home_switch('T', true);
  EXPECT_EQ(rig.read8(reg::home), bit_of('T'));
  EXPECT_EQ(rig.read8(reg::home), bit_of('T')) << "live: reading clears nothing";
  rig.send("AT HH ");
  EXPECT_EQ(rig.read8(reg::home), 0) << "high is active now";
  rig.home_switch('T', false);
  EXPECT_EQ(rig.read8(reg::home), bit_of('T'));
  expect_read_only(rig, reg::home);
}

VME58_FORM("vme58.reg.vector") {
  expect_place(form, reg::vector);
  Rig rig;
  EXPECT_EQ(rig.read8(reg::vector), 0);
  rig.write8(reg::vector, 180);
  EXPECT_EQ(rig.read8(reg::vector), 180);
  rig.write8(reg::control, 0x90);
  rig.send("AX ID ");
  ASSERT_TRUE(rig.bus().interrupt());
  EXPECT_EQ(*rig.bus().interrupt(), 180);
}

// --- control bits ------------------------------------------------------------------------------------------

VME58_FORM("vme58.reg.control.bit0") {
  Rig rig;
  rig.send("AX LP1234 ");
  rig.write8(reg::control, 0x01);
  rig.run_for(899us);
  EXPECT_EQ(rig.read8(reg::control), 0x01);
  EXPECT_EQ(rig.read32(offset_of(0, AxisValue::command_position)), 0u);
  rig.run_for(1us);
  EXPECT_EQ(rig.read8(reg::control), 0x00) << "cleared by the board when it has copied";
  EXPECT_EQ(rig.read32(offset_of(0, AxisValue::command_position)), 1234u);
  rig.send("LP99 ");
  rig.run_for(1s);
  EXPECT_EQ(rig.read32(offset_of(0, AxisValue::command_position)), 1234u) << "only when it is asked";
  // The other bits stay as they are, and writing them does not take the request back.
  rig.write8(reg::control, 0x91);
  rig.write8(reg::control, 0x90);
  EXPECT_EQ(rig.read8(reg::control), 0x91);
  rig.run_for(1ms);
  EXPECT_EQ(rig.read8(reg::control), 0x90);
  EXPECT_EQ(rig.read32(offset_of(0, AxisValue::command_position)), 99u);
}

VME58_FORM("vme58.reg.control.bit1") {
  Rig rig;
  rig.write8(reg::control, 0x02);
  rig.send("AX ID ");
  rig.run_for(10ms);
  EXPECT_EQ(rig.read8(reg::control), 0x02) << "kept, without a function";
  EXPECT_EQ(rig.status(), status::initialized | status::done);
  EXPECT_FALSE(rig.bus().interrupt());
}

VME58_FORM("vme58.reg.control.bit2") { expect_interrupt_by(control::slip_interrupt, slip_with_is); }

VME58_FORM("vme58.reg.control.bit3") { expect_interrupt_by(control::limit_interrupt, meet_limit); }

VME58_FORM("vme58.reg.control.bit4") {
  expect_interrupt_by(control::done_interrupt, raise_done);
  // One interrupt for each ID, also while flags are set, its own among them.
  Rig rig;
  rig.write8(reg::control, 0x90);
  rig.send("AX ID ");
  rig.bus().acknowledge();
  rig.send("AY ID ");
  EXPECT_TRUE(rig.bus().interrupt());
  rig.bus().acknowledge();
  rig.send("AY ID ");
  EXPECT_TRUE(rig.bus().interrupt()) << "the host has not read the one before";
  rig.bus().acknowledge();
  // What was pending before it was let through.
  rig.write8(reg::control, 0x00);
  rig.write8(reg::control, 0x90);
  EXPECT_TRUE(rig.bus().interrupt());
}

VME58_FORM("vme58.reg.control.bit5") {
  Rig rig;
  rig.send("AX JG1000 ");
  rig.run_for(1s);
  rig.write16(at::mailbox, 'K');
  rig.write16(at::mailbox + 2, 'L');
  EXPECT_TRUE(rig.moving('X')) << "the cells alone do nothing";
  rig.write8(reg::control, 0x20);
  EXPECT_FALSE(rig.moving('X'));
  EXPECT_EQ(rig.read8(reg::control), 0x20);
  rig.run_for(1ms);
  EXPECT_EQ(rig.read8(reg::control), 0x00) << "cleared by the board";
}

VME58_FORM("vme58.reg.control.bit6") {
  expect_interrupt_by(control::io_interrupt, pull_input_0);
  Rig rig;
  rig.write8(reg::control, 0xC0);
  rig.line(2, true);
  EXPECT_FALSE(rig.bus().interrupt()) << "inputs 0 and 1 only";
  rig.line(1, true);
  EXPECT_TRUE(rig.bus().interrupt());
  rig.bus().acknowledge();
  rig.line(1, false);
  EXPECT_FALSE(rig.bus().interrupt()) << "when it goes low";
}

// --- status bits -------------------------------------------------------------------------------------------

VME58_FORM("vme58.reg.status.bit1") {
  Rig rig;
  EXPECT_NE(rig.status() & status::initialized, 0);
  EXPECT_NE(rig.status() & status::initialized, 0) << "reading does not clear it";
  rig.send("RS");
  EXPECT_EQ(rig.status(), 0);
  rig.run_for(99ms);
  EXPECT_EQ(rig.status(), 0);
  rig.run_for(1ms);
  EXPECT_EQ(rig.status(), status::initialized);
}

VME58_FORM("vme58.reg.status.bit3") {
  Rig rig;
  meet_limit(rig);
  rig.limit('X', '+', false);
  EXPECT_NE(rig.status() & status::overtravel, 0);
  EXPECT_NE(rig.status() & status::overtravel, 0);
  rig.read8(reg::limit);
  EXPECT_EQ(rig.status() & status::overtravel, 0);
}

// --- the mailbox -------------------------------------------------------------------------------------------

VME58_FORM("vme58.mailbox") {
  Rig rig;
  rig.send("AX JG1000 AY JG-2000 ");
  rig.run_for(1s);
  // The ring is of no use now: its first command waits for an empty queue.
  rig.send("AX WH WT10 WG WQ RP");
  rig.run_for(10ms);
  EXPECT_EQ(rig.output(), "");
  rig.write32(at::mailbox, 5439553);
  rig.write8(reg::control, 0x20);
  rig.run_for(10ms);
  EXPECT_NE(rig.output(), "") << "SA has emptied the queues, so WQ is over";
  EXPECT_EQ(rig.read32(at::mailbox), 0u) << "free again";
  rig.run_for(2s);
  EXPECT_FALSE(rig.moving('X'));
  EXPECT_FALSE(rig.moving('Y'));
  // Only stops and clears go through it.
  rig.send("AX ID ");
  rig.mail("IC");
  EXPECT_EQ(rig.done(), 0);
  rig.run_for(1ms);
  rig.mail("GO");
  EXPECT_TRUE(rig.command_error());
}

}  // namespace hw::vme58::proof
