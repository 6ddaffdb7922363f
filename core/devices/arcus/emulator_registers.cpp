// Registers: settings with their side effects, status words, counters, timers.
#include <algorithm>
#include <cmath>

#include "core/devices/arcus/emulator_controller.h"

namespace hw::arcus {

std::int64_t Controller::read_setting(Setting id, int which) const {
  const std::int64_t written = settings_.get(id, which);
  const bool ramp = id == Setting::accel || id == Setting::decel;
  const bool axis_ramp = id == Setting::axis_accel || id == Setting::axis_decel;
  if (!ramp && !(axis_ramp && written != 0)) return written;
  const bool of_one_axis = axis_ramp || !settings_.has(Setting::axis_accel);
  SpeedOrder o = of_one_axis ? order(which) : SpeedOrder();
  if (ramp) o.high = settings_.get(Setting::high_speed), o.low = settings_.get(Setting::low_speed);
  return adjusted_ms(*model_, o, written);
}

Refusal Controller::write_setting(Setting id, std::int64_t value, int which) {
  bring_up_to_date();
  switch (id) {
    case Setting::modbus:
      if (value != 0 && !settings_.on(Setting::line_type)) return Refusal::needs_rs485;
      break;
    case Setting::loop: {
      if (moving(which) || (value != 0 && joystick_on(which))) return Refusal::moving;
      Axis& axis = axes_[ix(which)];
      counter_is_written(which);
      if (value != 0) axis.target = encoder(which);
      if (value == 0 && closed(which))
        axis.pulses = std::llround(static_cast<double>(encoder(which)) * ratio(which));
      axis.loop_error.reset();
      axis.attempts = 0;
      axis.aborted_until = Instant{};
      break;
    }
    case Setting::joystick:
      for (int a = 0; a < axes(); ++a)
        if ((value >> a & 1) != 0 && !joystick_on(a) && moving(a)) return Refusal::moving;
      for (int a = 0; a < axes(); ++a)
        if ((value >> a & 1) != 0 && closed(a)) (void)write_setting(Setting::loop, 0, a);
      break;
    default: break;
  }
  settings_.set(id, value, which);
  switch (id) {
    case Setting::comm_timeout:
      timeout_.forget();
      if (!host_talks) timeout_.command_came(value, now_);
      break;
    case Setting::joystick:
    case Setting::joystick_limits:
    case Setting::joystick_max:
    case Setting::joystick_min:
    case Setting::joystick_values: schedule_joystick(); break;
    case Setting::polarity:
    case Setting::sync_condition:
    case Setting::sync_position:
    case Setting::sync_width:
    case Setting::loop_ratio:
    case Setting::loop_range:
    case Setting::loop_tolerance:
      for (int a = 0; a < axes(); ++a) bench_changed(a);
      break;
    default: break;
  }
  return Refusal::none;
}

// --- status ------------------------------------------------------------------------------------------------

std::int64_t Controller::status(int a) const {
  const StatusBits& bits = model_->status;
  std::int64_t word = 0;
  const auto set = [&word](int bit, bool on) {
    if (bit != no_bit && on) word |= std::int64_t{1} << bit;
  };
  const Axis& axis = axes_[ix(a)];
  if (const Motion* m = motion_of(a)) {
    motion::Phase phase = m->profile.phase(now_);
    if (m->kind == MotionKind::joystick) {
      const double now = joystick_.speed[ix(a)], target = joystick_target(a);
      const bool faster = target * now > 0 && std::abs(target) > std::abs(now);
      if (target != now) phase = faster ? motion::Phase::accelerating : motion::Phase::decelerating;
    }
    set(bits.accelerating, phase == motion::Phase::accelerating);
    set(bits.decelerating, phase == motion::Phase::decelerating);
    set(bits.constant, phase != motion::Phase::accelerating && phase != motion::Phase::decelerating);
  }
  set(bits.alarm, alarm_active(a));
  set(bits.plus_limit, limit_active(a, Sign::plus));
  set(bits.minus_limit, limit_active(a, Sign::minus));
  set(bits.home, home_active(a));
  set(bits.plus_error, axis.plus_error);
  set(bits.minus_error, axis.minus_error);
  set(bits.alarm_error, axis.alarm_error);
  if (bits.latch != no_bit) set(bits.latch, latch_input_active(a));
  if (bits.index != no_bit) set(bits.index, axis.index_operated());
  set(bits.timed_out, timeout_.fired() && a == 0);
  return word;
}

std::int64_t Controller::position(int a) const {
  return closed(a) ? wrap_position(target(a)) : wrap_position(axes_[ix(a)].pulses);
}

std::int64_t Controller::speed(int a) const {
  const Motion* m = motion_of(a);
  if (m == nullptr) return 0;
  const double speed = m->profile.speed(now_).value;
  if (m->kind == MotionKind::interpolated || m->kind == MotionKind::buffered)
    return std::llround(speed * m->track.pulses_per_step() *
                        std::abs(m->track.share(ix(a), m->profile.distance(now_))));
  return std::llround(speed / ratio(a));
}

Duration Controller::ramp_to_rest(int a) const {
  const Motion* m = motion_of(a);
  return m == nullptr ? Duration{} : from_seconds(m->profile.speed(now_).value / stop_ramps(*m).ramp.decel);
}

Refusal Controller::set_position(int a, std::int64_t value) {
  bring_up_to_date();
  if (moving(a)) return Refusal::moving;
  Axis& axis = axes_[ix(a)];
  counter_is_written(a);
  if (closed(a)) {
    if (!model_->positions_may_be_written_in_loop) return Refusal::unknown;
    axis.target = value;
    axis.set_encoder(value);
  }
  axis.pulses = value;
  update_sync(a);
  return Refusal::none;
}

/// With StepNLoop the target is set too, so that no correction follows.
Refusal Controller::set_encoder(int a, std::int64_t value) {
  bring_up_to_date();
  if (moving(a)) return Refusal::moving;
  Axis& axis = axes_[ix(a)];
  counter_is_written(a);
  const std::int64_t delta = loop_delta(a);
  axis.set_encoder(value);
  if (closed(a))
    axis.target = model_->positions_may_be_written_in_loop ? value : wrap_position(value + delta);
  update_sync(a);
  return Refusal::none;
}

/// Run current during a move and for CURT after it, then idle current. A correction for SLM uses idle
/// current.
std::int64_t Controller::current_ma() const {
  if (terminals_.enables == 0) return 0;  // DMX manual, ch. 7: EO switches the motor's power
  const Axis& axis = axes_[0];
  const std::int64_t run = settings_.get(Setting::run_current), idle = settings_.get(Setting::idle_current);
  if (const Motion* m = motion_of(0))
    return m->kind == MotionKind::correction && axis.extra_done ? idle : run;
  return now_ < axis.rested_at + std::chrono::milliseconds(settings_.get(Setting::idle_time)) ? run : idle;
}

std::int64_t Controller::timer_ms() const {
  if (timer_end_ <= now_) return 0;
  return std::chrono::ceil<std::chrono::milliseconds>(timer_end_ - now_).count();
}

void Controller::set_timer(std::int64_t ms) { timer_end_ = now_ + std::chrono::milliseconds(ms); }

void Controller::command_answered(bool timeout_was_shown) {
  if (timeout_was_shown) timeout_.was_shown();
  if (!host_talks) timeout_.command_came(settings_.get(Setting::comm_timeout), now_);
}

void Controller::note_event(std::string what, unsigned axes, int limit) {
  if (trace != nullptr) trace->push_back({now_, std::move(what), vm_.line_at_work(), axes, limit});
}

void Controller::note_read(const std::string& input, int value) {
  note_event("reads " + input + ": " + std::to_string(value));
  if (trace == nullptr) return;
  trace->back().reads = true;
  const bool one_line = input.starts_with("DI") && input.size() > 2;  // a number is neither on nor off
  trace->back().io = input, trace->back().level = one_line ? value : 0;
}

}  // namespace hw::arcus
