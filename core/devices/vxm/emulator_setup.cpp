// Program entry, set and get, rsm, setD0 (Program Management, Setup Commands, App. C to J, N, O).
#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vxm/emulator_box.h"
#include "core/devices/vxm/report.h"

namespace hw::vxm {
namespace {

bool within(std::int64_t v, std::int64_t min, std::int64_t max) { return v >= min && v <= max; }

}  // namespace

bool Box::slave_found() const {
  return (memory_.setup.mode & mode_master) != 0 && slave() != nullptr && slave()->supply_.on;
}

Box* Box::need_slave() {
  if (slave_found()) return slave();
  send_error(error_bus);
  reset();
  return nullptr;
}

void Box::store(const Reading& word) {
  const auto what = meaning(word, host_.entry.motor, rules_.nf90);
  const Command* command = std::get_if<Command>(&what);
  if (command == nullptr) return;  // out of range: dropped without a word (V09)
  if (command->motor != 0) host_.entry.motor = command->motor;
  if (host_.entry.group && is_index(command->op)) {
    host_.entry.group->parts.push_back(*command);
    if (bytes_of(*host_.entry.group) <= memory_.programs[ix(host_.entry.program)].free()) return;
    host_.entry.group.reset();
    return raise(error_memory);
  }
  host_.entry.group.reset();
  if (!memory_.programs[ix(host_.entry.program)].add(*command)) raise(error_memory);
}

void Box::store_group() {
  if (!host_.entry.group) return;
  const Command group = *host_.entry.group;
  host_.entry.group.reset();
  if (group.parts.empty()) return;
  if (!memory_.programs[ix(host_.entry.program)].add(group)) raise(error_memory);
}

void Box::select_program(const Reading& w) {
  if (!w.has_value) return reply(number_reply(host_.entry.program));
  if (w.value >= program_count) return;
  host_.entry.program = static_cast<int>(w.value);
  if (w.minus) memory_.programs[ix(host_.entry.program)].clear();
}

void Box::associate(const Reading& w) {
  Setup& setup = memory_.setup;
  if (!w.has_value) {
    const bool off = setup.pma == pma_off;
    return reply((setup.pma_except && !off ? "-" : "") + number_reply(setup.pma));
  }
  const bool off = w.value == pma_off && !w.minus;
  if (!off && w.value >= program_count) return;
  setup.pma = static_cast<int>(w.value);
  setup.pma_except = w.minus;
}

void Box::set_inputs(int value) {
  if (value & inputs_capture) value &= ~inputs_stop;
  if (value & inputs_select) value &= ~inputs_branch_3;
  memory_.setup.inputs = value;
}

void Box::set_value(const Reading& w) {
  const bool for_motor = form_of(w.head).motor == Part::required;
  if (for_motor && (w.motor < 1 || w.motor > max_motors)) return;
  if (w.value > 100'000 || (w.minus && w.head != Head::set_L)) return;
  const int value = static_cast<int>(w.value);
  if (for_motor) {
    Box* box = w.motor > motors_per_controller ? need_slave() : this;
    if (box != nullptr) box->set_motor_value(w.head, (w.motor - 1) % motors_per_controller, value, w.minus);
    return;
  }
  Setup& setup = memory_.setup;
  switch (w.head) {
    case Head::B:
      if (value <= max_backlash) setup.backlash = value == 1 ? backlash_of_one : value;
      break;
    case Head::O:
      if (value <= max_limit_report) setup.limit_report = value;
      break;
    case Head::set_B:
      if (std::any_of(bauds.begin(), bauds.end(), [&](const Baud& b) { return b.number == value; }))
        setup.baud = value;
      break;
    case Head::set_DM:
      if (value <= 255) setup.mode = value | mode_always;
      break;
    case Head::set_DA:
      if (within(value, 20, 100)) setup.dead_zone = value;
      break;
    case Head::set_PA:
      if (!within(value, 1, 255)) return;
      setup.pulse_width = value;
      if (slave_found()) slave()->memory_.setup.pulse_width = value;  // its pulses for motors 3 and 4
      break;
    case Head::set_I:
      if (value <= 255) set_inputs(value);
      break;
    default: break;
  }
  update_rules();
}

void Box::set_motor_value(Head head, int axis, int value, bool minus) {
  Setup& setup = memory_.setup;
  const std::size_t i = ix(axis);
  switch (head) {
    case Head::set_M:
    case Head::set_MA:
      if (value > max_motor_type) return;
      setup.motor_type[i] = value;
      setup.full_jog_power[i] = head == Head::set_MA;
      return;
    case Head::set_j:
      if (value <= max_speed) setup.jog_1[i] = value;
      return;
    case Head::set_J:
      if (within(value, min_jog_2, max_speed)) setup.jog_2[i] = value;
      return;
    case Head::set_jA:
      if (value <= max_joystick_range) setup.joy_1[i] = value;
      return;
    case Head::set_JA:
      if (value <= 24) setup.joy_2[i] = value;
      return;
    case Head::set_L:
      if (value > 2 || (minus && value == 0)) return;
      setup.limit_mode[i] = minus ? -value : value;
      return plant_changed(axis);
    case Head::set_P:
      if (value > max_pulse_every) return;
      setup.pulse_every[i] = value;
      axes_[i].comb = 0;
      return;
    default: return;
  }
}

void Box::get_value(const Reading& w) {
  const Setup& mine = memory_.setup;
  switch (w.head) {
    case Head::get_DM: return reply(number_reply(mine.mode));
    case Head::get_D0: return reply(fmt::format("{}.{:02}\r", quirks.firmware / 100, quirks.firmware % 100));
    case Head::get_D1: return reply(std::string(firmware_date) + '\r');
    case Head::get_D2: return reply(number_reply(slave_found() ? 4 : 2));
    case Head::get_DA: return reply(number_reply(mine.dead_zone));
    case Head::get_PA:
      if (quirks.firmware >= firmware_of_pulses) reply(number_reply(mine.pulse_width));
      return;
    case Head::get_I: return reply(number_reply(mine.inputs));
    default: break;
  }
  if (w.motor < 1 || w.motor > max_motors) return;
  const Box* box = w.motor > motors_per_controller ? need_slave() : this;
  if (box == nullptr) return;
  const Setup& setup = box->memory_.setup;
  const std::size_t i = ix((w.motor - 1) % motors_per_controller);
  switch (w.head) {
    case Head::get_M: return reply(number_reply(setup.motor_type[i]));
    case Head::get_j: return reply(number_reply(setup.jog_1[i]));
    case Head::get_J: return reply(number_reply(setup.jog_2[i]));
    case Head::get_jA: return reply(number_reply(setup.joy_1[i]));
    case Head::get_JA: return reply(number_reply(setup.joy_2[i]));
    case Head::get_L: return reply(number_reply(setup.limit_mode[i]));
    case Head::get_P: return reply(number_reply(setup.pulse_every[i]));
    default: return;
  }
}

void Box::update_rules() {
  const Setup& s = memory_.setup;
  rules_.nf90 = (s.mode & mode_nf90) != 0;
  rules_.backlash = s.backlash;
  rules_.inverted = {(s.mode & mode_invert_1) != 0, (s.mode & mode_invert_2) != 0};
  if (Box* other = slave()) {
    other->update_rules();
    if (!slave_found()) return;
    if (rules_.nf90) other->rules_.nf90 = true;
    other->rules_.backlash = s.backlash;  // one setting for all motors (V64)
    if (s.mode & mode_invert_3) other->rules_.inverted[0] = !other->rules_.inverted[0];
    if (s.mode & mode_invert_4) other->rules_.inverted[1] = !other->rules_.inverted[1];
  }
}

void Box::save() {
  saved_ = memory_;
  ++stores;
  if (slave_found()) slave()->saved_ = slave()->memory_;
  prompt(vxm::prompt);
}

/// setD0: restores the factory state, in non-volatile memory too (V88).
void Box::erase() {
  saved_ = Memory();
  ++stores;
  send_error(error_erased);
  reset();
}

}  // namespace hw::vxm
