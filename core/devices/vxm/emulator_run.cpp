// A program under way: one command after the other, hold, K, Stop, the end (Operation Commands, App. A, C,
// T).
#include <algorithm>

#include "core/base/index.h"
#include "core/devices/vxm/emulator_box.h"
#include "core/devices/vxm/report.h"

namespace hw::vxm {
namespace {

// Commands without a duration take no time, but an endless loop of them must let time pass.
constexpr int commands_at_once = 10'000;
constexpr Duration yield_time = Millis(1);

}  // namespace

void Box::note(std::string what) {
  if (trace != nullptr) trace->push_back({now_, -1, -1, std::move(what)});
}

void Box::start_run(int program) {
  host_.entry.reader.reset();
  host_.entry.drop_unfinished();  // Run may be pressed in the middle of a text
  state_.captures.clear();
  tally_ = RunTally();
  const bool stop_held = (memory_.setup.inputs & inputs_stop) != 0 && line(line_in_4).low && !is_slave_;
  if (stop_held) {  // no program runs while Stop is held (App. C); the host gets the report of a stopped one
    send_error(error_stopped);
    return prompt(vxm::prompt);
  }
  run_ = Run();
  run_.on = true;
  const bool program_4_first = state_.first_run && (memory_.setup.mode & mode_program_4_first) != 0;
  state_.first_run = false;
  if (program_4_first) run_.then_program = program;
  Frame frame;
  frame.program = program_4_first ? 4 : program;
  run_.stack.push_back(frame);
  const Setup& setup = memory_.setup;
  const bool coupled = setup.pma != pma_off && (setup.pma == program) != setup.pma_except;
  if (coupled && slave_found()) slave()->start_run(program);
}

bool Box::run_if_due() {
  if (!run_.on) return false;
  bool changed = false;
  switch (run_.doing) {
    case Doing::moving:
      if (motion_.active || (slave() != nullptr && slave()->motion_.active)) return report_first_of_pair();
      moves_done();
      changed = true;
      break;
    case Doing::pausing:
    case Doing::yielding:
      if (now_ < run_.until) return false;
      restore_out();
      run_.doing = Doing::next;
      changed = true;
      break;
    case Doing::waiting:
      if (!wait_if_due()) return false;
      changed = true;
      break;
    case Doing::for_host:
    case Doing::held: return false;
    case Doing::next: break;
  }
  return go_on() || changed;
}

bool Box::go_on() {
  bool changed = false;
  while (run_.on && run_.doing == Doing::next && execute_next()) changed = true;
  return changed;
}

/// False: no command can run now.
bool Box::execute_next() {
  if (motion_.active) return false;  // a jog still ramps down
  if (run_.stop_asked) return end_stopped_run(), true;
  if (run_.instant != now_) run_.instant = now_, run_.commands_this_instant = 0;
  if (++run_.commands_this_instant > commands_at_once) {
    if (run_.nonstop.moving) return raise(error_nonstop), true;
    run_.doing = Doing::yielding, run_.until = now_ + yield_time;
    return true;
  }
  if (run_.stack.empty()) {
    if (run_.then_program < 0) {
      if (slave() != nullptr && slave()->run_.on) return false;  // a coupled program goes on
      return finish_run(), true;
    }
    Frame frame;
    frame.program = run_.then_program;
    run_.then_program = -1;
    run_.stack.push_back(frame);
  }
  Frame& frame = run_.stack.back();
  const Program& program = memory_.programs[ix(frame.program)];
  if (frame.next >= program.size()) return end_frame(), true;
  int unit = 1;
  if (left_out(frame, program, unit)) {
    frame.next += unit;
    return true;
  }
  const Command command = program[frame.next];
  if (state_.hold && !run_.step_allowed && !run_.nonstop.moving && !is_slave_) {
    out += held + (quirks.firmware < firmware_of_listing ? "" : shown(command, terminals_.analog.value())) +
           '\r';
    run_.doing = Doing::held;
    return true;
  }
  const bool for_slave = command.motor > motors_per_controller || command.op == Op::group;
  // A coupled program uses the Slave's motors, or they ramp down after a jog.
  if (for_slave && slave() != nullptr && (slave()->run_.on || slave()->motion_.active)) return false;
  run_.step_allowed = false;
  if (trace != nullptr)
    trace->push_back({now_, frame.program, frame.next, shown(command, terminals_.analog.value())});
  const int at = frame.next++;
  perform(command, at);
  return true;
}

/// On its last pass Lx leaves out the command right before it, unless that is a loop command itself.
bool Box::left_out(const Frame& frame, const Program& program, int& unit) const {
  const Command& command = program[frame.next];
  if (is_loop(command.op)) return false;
  const bool pair = command.op == Op::user && command.value == 92 && frame.next + 1 < program.size() &&
                    program[frame.next + 1].op == Op::index;
  unit = pair ? 2 : 1;
  const int at = frame.next + unit;
  if (at >= program.size()) return false;
  const Command& loop = program[at];
  if (loop.op != Op::loop && loop.op != Op::loop_alternate) return false;
  return std::any_of(frame.loops.begin(), frame.loops.end(),
                     [&](const OpenLoop& l) { return l.at == at && l.passes == loop.value - 1; });
}

void Box::perform(const Command& command, int at) {
  if (run_.nonstop.on && !allowed_in_nonstop(command)) return raise(error_nonstop);
  if (is_loop(command.op)) return do_loop(command, at);
  switch (command.op) {
    case Op::index: return run_.nonstop.on ? nonstop_index(command) : do_index(command);
    case Op::home:
    case Op::index_to: return do_index_to(command);
    case Op::group: return do_group(command);
    case Op::set_zero: {
      Box* box = command.motor > motors_per_controller ? need_slave() : this;
      if (box == nullptr) return;
      box->axes_[ix((command.motor - 1) % motors_per_controller)].counter = 0;
      host_.entry.motor = command.motor;
      return;
    }
    case Op::jump: return do_jump(command.value);
    case Op::call: return do_call(command.value, false);
    case Op::call_pick: return do_call(command.value, true);
    case Op::user: return do_user(command, at);
    case Op::pause:
    case Op::pause_fine:
    case Op::pause_out:
    case Op::pause_out_fine: return do_pause(command);
    default: return do_speed(command);
  }
}

void Box::end_frame() {
  run_.stack.pop_back();
  if (run_.stack.empty() && run_.then_program < 0 && run_.nonstop.on) raise(error_nonstop);
}

void Box::finish_run() {
  note("the program ends");
  run_ = Run();
  prompt(vxm::prompt);
}

/// Starts the moves that the command still has to make; after the last, the next command follows.
void Box::begin_next_moves() {
  while (run_.on && run_.next_move < run_.moves.size()) {
    bool together = true;
    for (bool first = true; together && run_.next_move < run_.moves.size(); first = false) {
      const PlannedMove move = run_.moves[run_.next_move++];
      together = first && move.with_next;
      Box* box = move.motor > motors_per_controller ? need_slave() : this;
      if (box == nullptr) return;                         // everything is reset
      if (box != this) box->memory_.programs[0].clear();  // the Master works through it (App. G)
      host_.entry.motor = move.motor;
      ++tally_.moves_begun;
      box->begin_index((move.motor - 1) % motors_per_controller, move.distance, move.home);
    }
    run_.doing = Doing::moving;
    if (motion_.active || (slave() != nullptr && slave()->motion_.active)) return;
    take_motion_end(*this);
    if (slave() != nullptr) take_motion_end(*slave());
    if (run_.hit_limit) break;
  }
  if (!run_.on) return;
  if (run_.hit_limit) return finish_run();
  if (run_.pick_from) {
    const std::int32_t here = axes_[ix(run_.pick_axis)].counter;
    run_.way_back[ix(run_.pick_axis)] -= wrap_position(std::int64_t{here} - *run_.pick_from);
    run_.pick_from.reset();
  }
  run_.doing = Doing::next;
}

void Box::begin_moves() {
  run_.next_move = 0;
  begin_next_moves();
}

/// All motors started by this command stand.
void Box::moves_done() {
  if (motion_.ended && motion_.kind == MotionKind::nonstop) nonstop_motion_ended();
  take_motion_end(*this);
  if (slave() != nullptr && !slave()->run_.on) take_motion_end(*slave());
  if (!run_.on) return;
  if (run_.stop_asked) return end_stopped_run();
  if (run_.hit_limit) return finish_run();
  begin_next_moves();
}

/// For the first motor of a pair ( ) to stand: a limit switch hit is reported at once, not at the end of the
/// other motor (App. F).
bool Box::report_first_of_pair() {
  bool any_moved = false;
  for (Box* box : {this, slave()}) {
    if (box == nullptr || box->motion_.active || (box != this && box->run_.on)) continue;
    if (!box->motion_.ended || box->motion_.kind == MotionKind::nonstop) continue;
    take_motion_end(*box);
    any_moved = any_moved || !box->motion_.ended;
  }
  return any_moved;
}

/// Reports a limit hit to the host. It may end the program (App. F), except in a move to a limit.
void Box::take_motion_end(Box& box) {
  const MotionKind kind = box.motion_.kind;
  const bool homing = kind == MotionKind::home;
  if (!box.motion_.ended || kind == MotionKind::jog || kind == MotionKind::joystick) return;
  box.motion_.ended = false;
  if (box.motion_.end != MotionEnd::limit) return;
  tally_.limit_was_hit = true;
  if (trace != nullptr) {
    const int motor = box.motion_.axis + 1 + (&box == this ? 0 : motors_per_controller);
    const std::int32_t at = box.axes_[ix(box.motion_.axis)].counter;
    note("motor " + std::to_string(motor) + (homing ? " reaches its" : " hits a") + " limit switch at " +
         std::to_string(at));
    if (!homing)
      trace->back().motor = motor, trace->back().limit = static_cast<int>(factor(box.motion_.sign));
  }

  if (memory_.setup.limit_report & 1) prompt(over_travel);
  if ((memory_.setup.limit_report & 2) && !homing) run_.hit_limit = true;
}

void Box::restore_out() {
  if (!run_.out_raised) return;
  run_.out_raised = false;
  set_output(1, run_.out_before);
}

void Box::kill() {
  restore_out();
  cut_motion(MotionEnd::stopped);
  motion_.ended = false;
  jog_ = Jog();
  run_ = Run();
  state_.hold = false, state_.error = 0, terminals_.outputs.clear();
  host_.entry.reader.reset(), host_.entry.group.reset();
  if (Box* s = slave()) s->kill();
  prompt(vxm::prompt);
}

/// Error reports that halt the controller until K (Troubleshooting p.30).
void Box::raise(char letter) {
  cut_motion(MotionEnd::stopped);
  motion_.ended = false;
  run_ = Run();
  state_.error = letter;
  host_.reset_word.forget();
  send_error(letter);
  if (Box* s = slave(); s != nullptr && s->run_.on) {
    s->cut_motion(MotionEnd::stopped);
    s->run_ = Run();
  }
}

void Box::hold_toggle() {
  state_.hold = !state_.hold;
  if (!state_.hold && run_.doing == Doing::held) run_.doing = Doing::next;
}

void Box::go_signal() {
  if (Box* s = slave(); s != nullptr && s->run_.on) s->go_signal();
  if (run_.doing == Doing::held) run_.step_allowed = true;
  if (run_.doing == Doing::held || run_.doing == Doing::for_host) run_.doing = Doing::next;
}

void Box::stop_input() {
  if (!run_.on || run_.stop_asked || is_slave_) return;
  send_error(error_stopped);
  run_.stop_asked = true;
  const bool hard = (memory_.setup.inputs & inputs_hard_stop) != 0;
  for (Box* box : {this, slave()}) {
    if (box == nullptr) continue;
    if (hard)
      box->cut_motion(MotionEnd::stopped);
    else
      box->decelerate();
    if (box != this) box->run_ = Run();
  }
  const bool moving = motion_.active || (slave() != nullptr && slave()->motion_.active);
  run_.doing = moving ? Doing::moving : Doing::next;
  if (!moving) end_stopped_run();
}

void Box::end_stopped_run() {
  restore_out();
  if (run_.wait.raised) end_wait();
  finish_run();
  if ((memory_.setup.inputs & inputs_program_4) == 0) return;
  run_.on = true;
  Frame frame;
  frame.program = 4;
  run_.stack.push_back(frame);
}

}  // namespace hw::vxm
