// Waits for inputs and buttons (Pausing and I/O, App. B, C).
#include <algorithm>

#include "core/devices/vxm/emulator_box.h"

namespace hw::vxm {
namespace {

bool raises_output(int u) { return u == 1 || u == 31 || u == 51; }

/// A press that began after `begun`.
std::optional<Instant> fresh(const Line& line, Instant begun, Duration hold) {
  if (!line.low || line.since < begun) return std::nullopt;
  return line.since + hold;
}

}  // namespace

Duration Box::valid_time() const {
  return (memory_.setup.inputs & inputs_fast) != 0 ? std::chrono::microseconds(100)
                                                   : std::chrono::microseconds(1000);
}

const Box& Box::wait_box() const { return run_.wait.on_slave && slave() != nullptr ? *slave() : *this; }

/// Input 3 ends a user wait with a jump to program 3 (setI bit 2).
bool Box::branch_low() const {
  if ((memory_.setup.inputs & inputs_branch_3) == 0) return false;
  return line(line_in_3).low || wait_box().line(line_in_3).low;
}

void Box::begin_wait(int u, bool on_slave) {
  run_.wait = Wait();
  run_.wait.u = u, run_.wait.on_slave = on_slave, run_.wait.begun = now_;
  run_.doing = Doing::waiting;
  if (!raises_output(u)) return;
  Box& box = on_slave ? *slave() : *this;
  run_.wait.raised = true;
  run_.wait.out_before = box.terminals_.outputs.first_is_on();
  box.set_output(1, true);
}

/// When the wait ends or takes its next step, if the lines stay as they are.
std::optional<Instant> Box::wait_event() const {
  if (run_.doing != Doing::waiting) return std::nullopt;
  if (branch_low()) return now_;
  const Wait& w = run_.wait;
  const Box& box = wait_box();
  const auto low_then_high = [&](const Line& line, Duration hold) { return line.stable(!w.low_seen, hold); };
  switch (w.u) {
    case 0:
    case 1: return box.line(line_in_1).stable(true, valid_time());
    case 30:
    case 31: return low_then_high(box.line(line_in_1), valid_time());
    case 50:
    case 51: return low_then_high(box.line(line_in_1), debounce);
    case 90: return low_then_high(box.line(line_run), debounce);
    case 32: return fresh(box.line(line_jog), w.begun, debounce);
    case 33: return fresh(box.line(line_jog + 1), w.begun, debounce);
    default: break;  // 13, 23
  }
  std::optional<Instant> first;
  for (const int button : {line_jog + 0, line_jog + 1, int{line_run}})
    first = earlier(first, fresh(box.line(button), w.begun, valid_time()));
  return first;
}

bool Box::wait_if_due() {
  const auto due = wait_event();
  if (!due || *due > now_) return false;
  Wait& w = run_.wait;
  if (branch_low()) {
    end_wait();
    do_jump(3);
    return true;
  }
  const bool two_steps = w.u == 30 || w.u == 31 || w.u == 50 || w.u == 51 || w.u == 90;
  if (two_steps && !w.low_seen) {
    w.low_seen = true;
    return true;
  }
  const int u = w.u;
  const Instant begun = w.begun;
  const Box& box = wait_box();
  const auto pressed = [&](int button) {
    const auto at = fresh(box.line(button), begun, valid_time());
    return at && *at <= now_;
  };
  const int program = pressed(line_jog) ? 1 : pressed(line_jog + 1) ? 2 : 0;
  end_wait();
  if (program == 0 || (u != 13 && u != 23)) return true;
  if (u == 13)
    do_jump(program);
  else
    do_call(program, false);
  return true;
}

void Box::end_wait() {
  Wait& w = run_.wait;
  if (w.raised) {
    Box& box = w.on_slave && slave() != nullptr ? *slave() : *this;
    box.set_output(1, w.out_before);
  }
  w = Wait();
  run_.doing = Doing::next;
}

}  // namespace hw::vxm
