// Continuous index: U7, U77, U8 to U9, U91, U92, U99 (App. D and G).
#include <cmath>

#include "core/base/index.h"
#include "core/devices/vxm/emulator_box.h"

namespace hw::vxm {
namespace {}  // namespace

void Box::begin_nonstop(int signal) {
  if (run_.nonstop.on) return;  // an example loops back over its U7
  run_.nonstop = Nonstop();
  run_.nonstop.on = true;
  run_.nonstop.signal = signal;
}

/// Relative indexes of one motor, speeds, loops, jumps and outputs (V75).
bool Box::allowed_in_nonstop(const Command& c) const {
  if (is_loop(c.op)) return true;
  switch (c.op) {
    case Op::index:
      return c.motor <= motors_per_controller && (run_.nonstop.motor == 0 || run_.nonstop.motor == c.motor);
    case Op::speed:
    case Op::speed_full:
    case Op::analog_speed:
    case Op::analog_speed_full:
    case Op::jump:
    case Op::call:
    case Op::call_pick: return true;
    case Op::user: break;
    default: return false;
  }
  switch (c.value % slave_u_offset) {
    case 4:
    case 5:
    case 7:
    case 77:
    case 8:
    case 9:
    case 91:
    case 92:
    case 99:
    case 14:
    case 15:
    case 16:
    case 17:
    case 18:
    case 19: return true;
    default: return false;
  }
}

void Box::nonstop_index(const Command& command) {
  Nonstop& n = run_.nonstop;
  const int axis = command.motor - 1;
  const bool minus = (command.value < 0) != reversed(axis);
  const Sign sign = minus ? Sign::minus : Sign::plus;
  if (n.motor == 0) n.motor = command.motor;
  const bool goes_on = n.moving && n.sign == sign;
  const Pps now(goes_on ? n.speed : 0), wanted(axes_[ix(axis)].speed);
  n.sign = sign;
  host_.entry.motor = command.motor;
  ++tally_.moves_begun;
  run_.moves.clear();
  run_.next_move = 0;
  start_motion(MotionKind::nonstop, axis, sign,
               motion::Profile::change(now_, 0, now, wanted, ramp(axis), std::abs(command.value)));
  run_.doing = Doing::moving;
}

void Box::nonstop_motion_ended() {
  Nonstop& n = run_.nonstop;
  n.moving = motion_.end == MotionEnd::done;
  n.speed = n.moving ? motion_.profile.final_speed().value : 0;
  if (n.on && motion_.end != MotionEnd::stopped && !run_.stop_asked) nonstop_signal();
}

void Box::nonstop_signal() {
  if (run_.nonstop.signal == 8) {
    if (!is_slave_) out += index_passed;
    return;
  }
  if (run_.nonstop.signal != 7) return;
  Pulse pulse;
  pulse.at = now_, pulse.output = 2, pulse.axis = motion_.axis;
  pulse.width = std::chrono::microseconds(10 * memory_.setup.pulse_width);
  pulse.position = axes_[ix(motion_.axis)].counter;
  pulses.push_back(pulse);
  terminals_.outputs.pulse_until(pulse.at + pulse.width);
}

void Box::end_nonstop(int u, int at) {
  using motion::Profile;
  const Nonstop n = run_.nonstop;
  run_.nonstop = Nonstop();
  const int axis = std::max(n.motor, 1) - 1;
  run_.moves.clear();
  run_.next_move = 0;
  if (u == 92) {  // the index after it is the stopping distance
    Frame& frame = run_.stack.back();
    const Program& program = memory_.programs[ix(frame.program)];
    const bool there = frame.next < program.size() && program[frame.next].op == Op::index &&
                       (n.motor == 0 || program[frame.next].motor == n.motor);
    if (!there) return raise(error_nonstop);
    const Command index = program[frame.next++];
    if (!n.moving) return do_index(index);
    const bool minus = (index.value < 0) != reversed(axis);
    if (minus != (n.sign == Sign::minus)) return raise(error_nonstop);  // no stop goes backwards
    note_slowing(now_, axes_[ix(axis)].counter);
    start_motion(MotionKind::index, axis, n.sign,
                 Profile::stop_within(now_, 0, Pps(n.speed), std::abs(index.value)));
    run_.doing = Doing::moving;
    return;
  }
  if (u == 99 || !n.moving) return;
  note_slowing(now_, axes_[ix(axis)].counter);
  const Profile stop = Profile::stop(now_, 0, Pps(n.speed), ramp(axis).decel);
  start_motion(MotionKind::index, axis, n.sign, stop);
  run_.doing = Doing::moving;
  if (u != 91) return;
  // U91 rewrites itself as U92 and an index of that length, as they would be typed (V35).
  const std::int64_t way = std::max<std::int64_t>(stop.length(), 1);
  const bool minus = (n.sign == Sign::minus) != reversed(axis);
  Frame& frame = run_.stack.back();
  Program& program = memory_.programs[ix(frame.program)];
  program.rewrite_u91(at, Command(Op::index, n.motor, static_cast<std::int32_t>(minus ? -way : way)));
  for (Frame& f : run_.stack) {
    if (f.program != frame.program) continue;
    if (f.next > at) ++f.next;
    for (OpenLoop& l : f.loops)
      if (l.at > at) ++l.at;
  }
}

}  // namespace hw::vxm
