// The effect of each stored command: loops, jumps, indexes, pauses, outputs (Looping/Branching, App. G, P,
// S).
#include <algorithm>
#include <utility>

#include "core/base/index.h"
#include "core/devices/vxm/emulator_box.h"
#include "core/devices/vxm/report.h"

namespace hw::vxm {
namespace {

bool is_mirror(Op op) { return op == Op::mirror_2 || op == Op::mirror_12; }
bool is_counted(Op op) { return (op >= Op::loop && op <= Op::loop_always_alternate) || is_mirror(op); }
bool alternates(Op op) { return op == Op::loop_alternate || op == Op::loop_always_alternate; }

}  // namespace

int Box::open_loops() const {
  int n = 0;
  for (const Frame& f : run_.stack) n += static_cast<int>(f.loops.size());
  return n;
}

int Box::open_jumps() const {
  return static_cast<int>(
      std::count_if(run_.stack.begin(), run_.stack.end(), [](const Frame& f) { return f.called; }));
}

bool Box::in_pick() const {
  return std::any_of(run_.stack.begin(), run_.stack.end(), [](const Frame& f) { return f.pick; });
}

/// Some loops reverse relative moves of motors 1 and 2; nested loops combine by exclusive or (V42).
bool Box::reversed(int axis) const {
  if (in_pick()) return false;
  bool turned = false;
  for (const Frame& f : run_.stack) {
    const Program& program = memory_.programs[ix(f.program)];
    for (const OpenLoop& l : f.loops) {
      const Op op = program[l.at].op;
      const bool concerns = axis == 0 ? alternates(op) || op == Op::mirror_12 : is_mirror(op);
      if (concerns && l.passes % 2 == 1) turned = !turned;
    }
  }
  return turned;
}

void Box::do_loop(const Command& command, int at) {
  Frame& frame = run_.stack.back();
  const int target = memory_.programs[ix(frame.program)].loop_target(at);
  if (command.op == Op::loop_endless) return jump_back(frame, target);
  if (!is_counted(command.op)) return;  // a marker: only its place counts
  auto open =
      std::find_if(frame.loops.begin(), frame.loops.end(), [at](const OpenLoop& l) { return l.at == at; });
  if (open == frame.loops.end()) {
    if (open_loops() == max_open_loops) return raise(error_loops);
    open = frame.loops.insert(frame.loops.end(), OpenLoop{at, 0});
  }
  const int passes = is_mirror(command.op) ? 2 : command.value;
  if (++open->passes < passes) return jump_back(frame, target);
  frame.loops.erase(open);
}

void Box::jump_back(Frame& frame, int target) {
  frame.next = target;
  run_.commands_this_instant += 1000;  // an endless loop must let time pass soon
}

void Box::do_jump(int program) {
  Frame& frame = run_.stack.back();
  frame.program = program;
  frame.loops.clear();
  jump_back(frame, 0);
}

void Box::do_call(int program, bool pick) {
  if (open_jumps() == max_open_jumps) return raise(error_jumps);
  Frame frame;
  frame.program = program, frame.called = true, frame.pick = pick;
  run_.stack.push_back(frame);
}

/// Undoes the absolute indexes inside JM-x, except those of `but_axis` (App. S, V50).
void Box::plan_ways_back(int but_axis) {
  for (int axis = 0; axis < motors_per_controller; ++axis) {
    if (axis == but_axis || run_.way_back[ix(axis)] == 0) continue;
    PlannedMove move;
    move.motor = axis + 1, move.distance = run_.way_back[ix(axis)];
    run_.way_back[ix(axis)] = 0;
    run_.moves.push_back(move);
  }
}

void Box::plan_relative(const Command& command, bool with_next) {
  PlannedMove move;
  move.motor = command.motor, move.distance = command.value, move.with_next = with_next;
  const int axis = command.motor - 1;
  if (axis < motors_per_controller) {
    if (reversed(axis)) move.distance = -move.distance;
    if (!in_pick()) move.distance += std::exchange(run_.way_back[ix(axis)], 0);
  }
  run_.moves.push_back(move);
}

void Box::do_index(const Command& command) {
  run_.moves.clear();
  if (!in_pick()) plan_ways_back(command.motor - 1);
  plan_relative(command, false);
  begin_moves();
}

/// IAmMx, and moves to a limit.
void Box::plan_index_to(const Command& command, bool with_next) {
  const int axis = (command.motor - 1) % motors_per_controller;
  const Box* box = command.motor > motors_per_controller ? slave() : this;
  PlannedMove move;
  move.motor = command.motor, move.with_next = with_next;
  // In NF90 emulation ImM0 goes to absolute zero (App. P).
  const bool to_limit = command.op == Op::home && !(rules_.nf90 && command.value > 0);
  if (to_limit) {
    move.home = command.value;
  } else {
    if (in_pick() && command.motor <= motors_per_controller) {
      run_.pick_from = axes_[ix(axis)].counter;
      run_.pick_axis = axis;
    } else if (command.op == Op::index_to) {
      run_.way_back = {};  // App. S, note 3
    }
    const std::int64_t target = command.op == Op::home ? 0 : command.value;
    if (box != nullptr) move.distance = target - box->axes_[ix(axis)].counter;
  }
  run_.moves.push_back(move);
}

void Box::do_index_to(const Command& command) {
  run_.moves.clear();
  if (command.motor > motors_per_controller && need_slave() == nullptr) return;
  plan_index_to(command, false);
  begin_moves();
}

/// ( ): a Slave's index runs together with the Master's that follows it; else one after the other (App. G).
void Box::do_group(const Command& command) {
  run_.moves.clear();
  for (const Command& part : command.parts)
    if (part.motor > motors_per_controller && need_slave() == nullptr) return;
  const bool relative = std::any_of(command.parts.begin(), command.parts.end(),
                                    [](const Command& c) { return c.op == Op::index; });
  if (relative && !in_pick()) {
    for (int axis = 0; axis < motors_per_controller; ++axis) {
      const bool own = std::any_of(command.parts.begin(), command.parts.end(), [&](const Command& c) {
        return c.op == Op::index && c.motor == axis + 1;
      });
      if (!own) plan_ways_back(1 - axis);
    }
  }
  for (std::size_t i = 0; i < command.parts.size(); ++i) {
    const Command& part = command.parts[i];
    const bool pair = part.motor > motors_per_controller && i + 1 < command.parts.size() &&
                      command.parts[i + 1].motor <= motors_per_controller;
    if (part.op == Op::index) {
      plan_relative(part, pair);
    } else if (part.op == Op::set_zero) {
      Box* box = part.motor > motors_per_controller ? slave() : this;
      box->axes_[ix((part.motor - 1) % motors_per_controller)].counter = 0;
    } else {
      plan_index_to(part, pair);
    }
  }
  begin_moves();
}

void Box::do_speed(const Command& command) {
  Box* box = command.motor > motors_per_controller ? need_slave() : this;
  if (box == nullptr) return;
  if (box != this) box->memory_.programs[0].clear();
  host_.entry.motor = command.motor;
  Axis& axis = box->axes_[ix((command.motor - 1) % motors_per_controller)];
  switch (command.op) {
    case Op::speed:
    case Op::speed_full: axis.speed = command.value; return;
    case Op::accel: axis.accel = command.value; return;
    default:
      if (const AnalogRange* range = find_analog_range(command.value))
        axis.speed = analog_speed(*range, terminals_.analog.value());
  }
}

void Box::do_pause(const Command& command) {
  const bool fine = command.op == Op::pause_fine || command.op == Op::pause_out_fine;
  const bool out_1 = command.op == Op::pause_out || command.op == Op::pause_out_fine;
  Duration length = fine ? Duration(std::chrono::microseconds(100LL * command.value))
                         : Duration(Millis(100LL * command.value));
  if (out_1 && length == Duration{}) length = std::chrono::microseconds(10);
  if (length == Duration{}) return;
  if (out_1 || (rules_.nf90 && state_.nf90_pause_out)) {
    run_.out_raised = true;
    run_.out_before = terminals_.outputs.first_is_on();
    set_output(1, true);
    if (out_1) {
      Pulse pulse;
      pulse.at = now_, pulse.output = 1, pulse.width = length, pulse.position = axes_[0].counter;
      pulses.push_back(pulse);
    }
  }
  run_.doing = Doing::pausing;
  run_.until = now_ + length;
}

void Box::set_output(int number, bool on) { terminals_.outputs.set(number, on); }

void Box::do_user(const Command& command, int at) {
  const bool on_slave = command.value >= slave_u_offset;
  Box* box = on_slave ? need_slave() : this;
  if (box == nullptr) return;
  const int u = command.value % slave_u_offset;
  switch (u) {
    case 2:
    case 3:
      if (rules_.nf90 && !on_slave)
        state_.nf90_pause_out = u == 3;  // App. P: the output of pauses, not jogging
      else
        box->state_.jog_in_waits = u == 2;
      return;
    case 4:
    case 5: return box->set_output(1, u == 5);
    case 14:
    case 15: return box->set_output(2, u == 15);
    case 16:
    case 17: return box->set_output(3, u == 17);
    case 18:
    case 19: return box->set_output(4, u == 19);
    case 6:
      prompt(waits_for_go);
      run_.doing = Doing::for_host;
      return;
    case 7:
    case 77:
    case 8: return begin_nonstop(u);
    case 9:
    case 91:
    case 92:
    case 99: return end_nonstop(u, at);
    case 11:
    case 12:
    case 21:
    case 22: return do_skip(u);
    default: return begin_wait(u, on_slave);
  }
}

/// U11 U12: skip when the input is high; U21 U22: when it is low.
void Box::do_skip(int u) {
  const bool low = line(line_in_1 + u % 10 - 1).low;
  if (low != (u > 20)) return;
  Frame& frame = run_.stack.back();
  if (frame.next < memory_.programs[ix(frame.program)].size()) ++frame.next;
}

}  // namespace hw::vxm
