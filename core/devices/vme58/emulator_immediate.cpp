// Commands that act at once: modes, settings, stops (decision M17).
#include <cmath>

#include "core/devices/vme58/emulator_board.h"

namespace hw::vme58 {

void Board::do_at_once(const Command& c) {
  if (stop_or_clear(c.op())) return;
  if (set_axis(c) || set_encoder(c)) return motion_.changed(context_);
  switch (c.op()) {
    case Op::LP: return load_positions(c);
    case Op::FP: return force_position(c);
    case Op::UU:
    case Op::UF: return set_units(c);
    case Op::CV: motion_.board().contour_velocity = c.first(); return;
    case Op::CD: return begin_recording(c);
    default: return set_mode(c);
  }
}

void Board::set_mode(const Command& c) {
  switch (c.op()) {
    case Op::AA: return select(context_all);
    case Op::AM: return select(context_tasks);
    case Op::AX:
    case Op::AY:
    case Op::AZ:
    case Op::AT:
    case Op::AU:
    case Op::AV:
    case Op::AR:
    case Op::AS: return select(static_cast<int>(c.op()) - static_cast<int>(Op::AX));
    case Op::EN: echo_ = true; return;
    case Op::EF: echo_ = false; return;
    case Op::CN: motion_.board().ramp = RampForm::cosine; return;
    case Op::PF: motion_.board().ramp = RampForm::linear; return;
    case Op::PN:
      motion_.board().ramp = RampForm::parabolic;
      motion_.board().truncation = static_cast<int>(c.first());
      return;
    case Op::WQ: waits_empty_ = context_; return;
    case Op::RS: return reset();
    default: return;
  }
}

/// A selector ends the recording of a contour; without its CE or CK it is not complete.
void Board::select(int context) {
  if (context < most_axes && (fitted_ >> context & 1u) == 0) return text_error();
  recorder_.give_up();
  context_ = context;
}

bool Board::set_axis(const Command& c) {
  if (context_ >= most_axes) return false;
  AxisSettings& s = motion_.settings(context_);
  switch (c.op()) {
    case Op::HH: s.home_active_high = true; return true;
    case Op::HL: s.home_active_high = false; return true;
    case Op::LF: s.limits_on = false; return true;
    case Op::LN: s.limits_on = true; return true;
    case Op::SL: s.soft_limits = true; return true;
    case Op::SF: s.soft_limits = false; return true;
    case Op::PI: s.pwm_period = c.first(); return true;
    case Op::BI: s.bipolar = true; return true;
    case Op::UN: s.bipolar = false; return true;
    case Op::PA: s.power_automatic = c.first() != 0; return true;
    case Op::SE: s.settling = Millis(static_cast<std::int64_t>(c.first())); return true;
    case Op::KP: s.gains.proportional = c.first(); return true;
    case Op::KI: s.gains.integral = c.first(); return true;
    case Op::KD: s.gains.differential = c.first(); return true;
    case Op::KV: s.gains.velocity_feed_forward = c.first(); return true;
    case Op::KA: s.gains.acceleration_feed_forward = c.first(); return true;
    case Op::KO: s.gains.offset = c.first(); return true;
    case Op::KN: s.gains.integration_exponent = static_cast<int>(c.first()); return true;
    default: return false;
  }
}

bool Board::set_encoder(const Command& c) {
  if (context_ >= most_axes) return false;
  AxisSettings& s = motion_.settings(context_);
  switch (c.op()) {
    case Op::ER:
      s.encoder_counts_per_ratio = c.first();
      s.motor_counts_per_ratio = *c.number[1];
      return true;
    case Op::HV: s.hold_velocity = c.first(); return true;
    case Op::HG: s.hold_gain = c.first(); return true;
    case Op::HD: s.hold_deadband = static_cast<std::int64_t>(c.first()); return true;
    case Op::ES: s.slip_tolerance = static_cast<std::int64_t>(c.first()); return true;
    case Op::HN: s.holding = true; return true;
    case Op::HF:
      s.holding = s.tracking = false;
      if (variant_->fitting(context_).kind == AxisKind::stepper) s.slip_tolerance = 0;  // decision M78
      return true;
    case Op::TN: s.slip_kills = true; return true;
    case Op::TF: s.slip_kills = false; return true;
    case Op::IS: s.slip_interrupts = true; return true;
    case Op::ET: s.tracking = true; return true;
    case Op::HE: s.home_needs_index = true; return true;
    case Op::HS: s.home_needs_index = false; return true;
    default: return false;
  }
}

void Board::set_units(const Command& c) {
  if (c.op() == Op::UF)
    return each_axis(context_axes(), [this](int a) { motion_.settings(a).user_unit = 0; });
  each(c, context_, [this](int a, double factor) { motion_.settings(a).user_unit = factor; });
}

void Board::load_positions(const Command& c) {
  each(c, context_, [this](int a, double p) { motion_.load_position(a, static_cast<std::int64_t>(p)); });
}

void Board::force_position(const Command& c) {
  flush(context_);
  if (!motion_.force_position(context_, static_cast<std::int64_t>(c.first()))) command_error();
}

// --- stops and flags ---------------------------------------------------------------------------------------

bool Board::stop_or_clear(Op op) {
  BoardTask& here = tasks_[ix(context_)];
  switch (op) {
    case Op::SA: stop_everything(); return true;
    case Op::SD:
      stop_everything();
      flags_.clear_done(~0u);
      return true;
    case Op::ST: {
      // In AA and AM: the axes that the queue has moved; if none, all axes (decision M58).
      const unsigned axes = context_ < most_axes || here.driven == 0 ? context_axes() : here.driven;
      flush(context_);
      stop_axes(axes);
      return true;
    }
    case Op::KL:
      flush_all();
      each_axis(fitted_, [this](int a) { motion_.kill(a); });
      return true;
    case Op::FL: {
      const unsigned axes = context_ < most_axes ? context_axes() : here.driven;
      flush(context_);
      each_axis(axes, [this](int a) { motion_.keep_velocity(a); });
      return true;
    }
    case Op::CW: here.leave_while = here.queue.has_while(); return true;
    case Op::IC: flags_.clear_all(); return true;
    case Op::CA: flags_.clear_done(context_axes()); return true;
    default: return false;
  }
}

void Board::stop_axes(unsigned axes) {
  each_axis(axes, [this](int a) { motion_.stop(a); });
}

void Board::stop_everything() {
  flush_all();
  stop_axes(fitted_);
}

void Board::flush(int context) {
  tasks_[ix(context)] = BoardTask();
  if (context == context_) held_.reset();
}

void Board::flush_all() {
  for (int context = 0; context < contexts; ++context) flush(context);
}

}  // namespace hw::vme58
