#include "core/devices/vxm/emulator_box.h"

#include <algorithm>
#include <utility>

#include "core/base/index.h"

namespace hw::vxm {
Box::Box() { power_up(); }

void Box::link(Box slave) {
  slave.is_slave_ = true;
  linked_.clear();
  linked_.push_back(std::move(slave));
  saved_.setup.mode |= mode_master;
  power_up();
}

void Box::power(bool on, Instant now) {
  if (on == supply_.on) return;
  set_time(now);
  cut_motion(MotionEnd::stopped);
  supply_.on = on, supply_.deaf = false;
  if (on) {
    power_up();
  } else {
    run_ = Run(), jog_ = Jog(), motion_.ended = false, state_.error = 0, terminals_.outputs.set_all(0);
    host_.mode.leave(), host_.entry.to_slave = false;
    out.clear(), replied = 0;
    if (Box* s = slave()) s->rules_.jogs = true;  // no Master forbids it
  }
}

/// A Master working through its Slave at that moment finds no Slave on the bus (p.10, 30).
void Box::power_slave(bool on, Instant now) {
  Box* s = slave();
  if (s == nullptr) return;
  set_time(now);
  const bool waits_there = run_.doing == Doing::waiting && run_.wait.on_slave;
  const bool at_work = run_.on && (s->motion_.active || s->run_.on || waits_there);
  s->power(on, now);
  if (!on) host_.entry.to_slave = false;
  if (!on && at_work && supply_.on) (void)need_slave();
}

void Box::reset() {
  cut_motion(MotionEnd::stopped);
  power_up();
  if (Box* s = slave()) s->reset();
  update_rules();
}

/// Forgets everything not in non-volatile memory.
void Box::power_up() {
  memory_ = saved_;
  supply_.since = now_;
  state_ = State();
  host_.mode.leave(), host_.reset_word.forget();
  host_.entry = HostEntry(), host_.bus_reader.reset();
  terminals_.outputs.clear();
  motion_ = Motion(), jog_ = Jog(), run_ = Run();
  terminals_.analog.take_as_centre();
  supply_.buttons_held = any_button_low();
  for (int i = 0; i < motors_per_controller; ++i) {
    Axis& a = axes_[ix(i)];
    a.counter = 0, a.comb = 0, a.speed = default_speed, a.accel = default_accel;
    a.seen_closed = {};
    note_closed(i);
  }
  update_rules();
}

bool Box::any_button_low() const {
  const auto low = [this](int i) { return line(i).low; };
  return low(0) || low(1) || low(2) || low(3) || low(line_run) || low(line_in_4);
}

void Box::set_time(Instant now) {
  now_ = std::max(now_, now);
  if (Box* s = slave()) s->set_time(now);
  sync();
}

bool Box::settle() {
  bool any = false;
  for (bool changed = true; changed;) {
    changed = slave() != nullptr && slave()->settle_own();
    changed = settle_own() || changed;
    any = any || changed;
  }
  return any;
}

bool Box::settle_own() {
  if (!supply_.on) return false;
  bool changed = end_motion_if_due();
  if (Box* s = slave(); s != nullptr && s->state_.error != 0 && state_.error == 0 && slave_found()) {
    raise(std::exchange(s->state_.error, '\0'));
    changed = true;
  }
  changed = run_if_due() || changed;
  changed = run_button_if_due() || changed;
  if (Box* s = slave()) {
    const bool waits = run_.doing == Doing::waiting && run_.wait.on_slave;
    const bool may_jog = !slave_found() || (run_.on ? waits && s->state_.jog_in_waits : !host_.mode.online);
    changed = changed || may_jog != s->rules_.jogs;
    s->rules_.jogs = may_jog;
  }
  return update_jog() || changed;
}

std::optional<Instant> Box::own_event() const {
  auto next = motion_event();
  if (run_.on && (run_.doing == Doing::pausing || run_.doing == Doing::yielding))
    next = earlier(next, run_.until);
  if (run_.on) next = earlier(next, wait_event());
  next = earlier(next, run_button_event());
  next = earlier(next, jog_event());
  return earlier(next, lamp_event());
}

std::optional<Instant> Box::next_event() const {
  std::optional<Instant> next;
  if (supply_.on) next = own_event();
  if (const Box* s = slave(); s != nullptr && s->supply_.on) next = earlier(next, s->own_event());
  return next;
}

}  // namespace hw::vxm
