#include "core/devices/vxm/program.h"

#include <algorithm>

namespace hw::vxm {
namespace {

std::string_view head_of(Op op) {
  switch (op) {
    case Op::index:
    case Op::home: return "I";
    case Op::index_to:
    case Op::set_zero: return "IA";
    case Op::speed:
    case Op::analog_speed: return "S";
    case Op::speed_full:
    case Op::analog_speed_full: return "SA";
    case Op::accel: return "A";
    case Op::loop:
    case Op::loop_alternate:
    case Op::loop_endless:
    case Op::marker_nf90: return "L";
    case Op::loop_always:
    case Op::loop_always_alternate: return "LA";
    case Op::marker:
    case Op::marker_reset:
    case Op::mirror_2:
    case Op::mirror_12: return "LM";
    case Op::jump: return "J";
    case Op::call:
    case Op::call_pick: return "JM";
    case Op::pause:
    case Op::pause_fine: return "P";
    case Op::pause_out:
    case Op::pause_out_fine: return "PA";
    case Op::user: return "U";
    case Op::group: return "(";
  }
  return "";
}

/// The text after the head and the motor.
std::string tail_of(const Command& c) {
  switch (c.op) {
    case Op::home: return c.value < 0 ? "-0" : "0";
    case Op::set_zero:
    case Op::marker_nf90:
    case Op::marker_reset: return "-0";
    case Op::marker:
    case Op::loop_endless: return "0";
    case Op::mirror_2: return "-2";
    case Op::mirror_12: return "-3";
    case Op::analog_speed:
    case Op::analog_speed_full:
    case Op::loop_alternate:
    case Op::loop_always_alternate:
    case Op::call_pick:
    case Op::pause_fine:
    case Op::pause_out_fine: return "-" + std::to_string(c.value);
    default: return std::to_string(c.value);
  }
}

}  // namespace

int bytes_of(const Command& command) {
  switch (command.op) {
    case Op::loop_endless:
    case Op::marker_nf90: return endless_loop_bytes;
    case Op::group: {
      int sum = pair_bytes;
      for (const Command& part : command.parts) sum += bytes_of(part);
      return sum;
    }
    case Op::user:
      if (command.value == 91) return u91_bytes;
      break;
    default: break;
  }
  const auto form = std::find_if(stored_forms.begin(), stored_forms.end(),
                                 [&](const StoredForm& f) { return f.head == head_of(command.op); });
  return form == stored_forms.end() ? 0 : form->bytes;
}

std::string listing_of(const Command& command) {
  std::string text(head_of(command.op));
  if (command.op == Op::group) {
    for (const Command& part : command.parts) text += listing_of(part) + ",";
    return text + ")";
  }
  if (command.motor != 0) text += std::to_string(command.motor) + "M";
  return text + tail_of(command);
}

bool is_loop(Op op) { return op >= Op::loop && op <= Op::mirror_12; }
bool is_index(Op op) { return op <= Op::set_zero; }

bool moves(const Command& command) {
  return command.op == Op::index || command.op == Op::home || command.op == Op::index_to ||
         command.op == Op::group;
}

const AnalogRange* find_analog_range(int number) {
  for (const AnalogRange& range : analog_ranges)
    if (range.number == number) return &range;
  return nullptr;
}

int analog_speed(const AnalogRange& range, int reading) {
  return std::max(min_speed, range.low + (range.high - range.low) * reading / analog_max);
}

bool Program::add(const Command& command) {
  const int bytes = bytes_of(command);
  if (bytes > free()) return false;
  commands_.push_back(command);
  used_ += bytes;
  return true;
}

void Program::remove_last() {
  if (commands_.empty()) return;
  used_ -= bytes_of(commands_.back());
  commands_.pop_back();
}

void Program::clear() {
  commands_.clear();
  used_ = 0;
}

void Program::rewrite_u91(int i, const Command& index) {
  commands_[static_cast<std::size_t>(i)] = Command(Op::user, 0, 92);
  commands_.insert(commands_.begin() + i + 1, index);
}

int Program::loop_target(int i) const {
  for (int k = i - 1; k >= 0; --k) {
    const Op op = (*this)[k].op;
    if (op == Op::marker || op == Op::marker_nf90) return k + 1;
    if (op == Op::marker_reset) return 0;
  }
  return 0;
}

}  // namespace hw::vxm
