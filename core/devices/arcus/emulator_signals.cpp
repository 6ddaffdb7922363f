// Inputs, outputs, polarities, latches and sync outputs.
#include <algorithm>

#include "core/devices/arcus/emulator_controller.h"

namespace hw::arcus {
namespace {

constexpr std::size_t most_open_pulses = 64;  // how far back the beginning of a pulse can lie

}  // namespace

bool Controller::inverted(const PolarityBit& polarity, int axis) const {
  if (polarity.bit == no_bit) return false;
  const std::int64_t word = settings_.get(Setting::polarity, axis);
  return ((word >> polarity.bit & 1) != 0) == polarity.inverts;
}

/// The load's direction when the axis is sent that way.
Sign Controller::load_way(int axis, Sign way) const {
  return inverted(model_->polarity.direction, axis) ? -way : way;
}

bool Controller::home_active(int a) const {
  return axes_[ix(a)].plant.home_operated() != inverted(model_->polarity.home, a);
}

/// The limit bit of the first axis applies to all (table 6.2).
bool Controller::limit_active(int a, Sign side) const {
  return axes_[ix(a)].plant.limit_operated(side) != limits_inverted();
}

bool Controller::alarm_active(int a) const {
  if (model_->status.alarm == no_bit) return false;
  return axes_[ix(a)].alarm_operated != inverted(model_->polarity.alarm, a);
}

bool Controller::latch_input_active(int a) const {
  const bool operated = (terminals_.inputs >> (model_->latch_inputs[ix(a)] - 1) & 1u) != 0;
  return operated != inverted(model_->polarity.latch, a);
}

std::int64_t Controller::inputs() const {
  const std::int64_t all = (std::int64_t{1} << model_->inputs) - 1;
  const bool turned = settings_.on(Setting::input_polarity) || inverted(model_->polarity.inputs, 0);
  return turned ? ~static_cast<std::int64_t>(terminals_.inputs) & all : terminals_.inputs;
}

bool Controller::sync_output_on(int a) const {
  const SyncOutput& s = axes_[ix(a)].sync;
  if (s.state == 0) return false;
  if (settings_.get(Setting::sync_condition, a) == 1 && settings_.get(Setting::sync_width, a) > 0)
    return s.open;
  return s.holds;
}

/// The real states, also of outputs that sync drives, and of In Position and Alarm where the model has them.
std::int64_t Controller::outputs() const {
  std::int64_t seen = terminals_.outputs;
  const auto show = [&seen](int number, bool on) {
    const std::int64_t bit = std::int64_t{1} << (number - 1);
    seen = on ? seen | bit : seen & ~bit;
  };
  for (int a = 0; a < axes(); ++a)
    if (axes_[ix(a)].sync.state != 0) show(model_->sync_outputs[ix(a)], sync_output_on(a));
  if (loop_has_outputs()) {
    const bool near = std::abs(loop_delta(0)) <= settings_.get(Setting::loop_tolerance, 0);
    show(model_->in_position_output, !moving(0) && !in_error(0) && near);
    show(model_->alarm_output, in_error(0));
  }
  return seen;
}

std::uint32_t Controller::output_levels() const {
  if (!powered_) return 0;
  const auto bit = [](int output) { return output > 0 ? 1u << (output - 1) : 0u; };
  const std::uint32_t all_outputs = (1u << model_->outputs) - 1, all_enables = (1u << model_->enables) - 1;
  const std::uint32_t in_position = loop_has_outputs() ? bit(model_->in_position_output) : 0;
  const std::uint32_t alarm = loop_has_outputs() ? bit(model_->alarm_output) : 0;
  std::uint32_t turned = 0;
  if (settings_.on(Setting::output_polarity) || inverted(model_->polarity.outputs, 0))
    turned |= all_outputs & ~(in_position | alarm);
  if (inverted(model_->polarity.in_position, 0)) turned |= in_position;
  if (inverted(model_->polarity.alarm_output, 0)) turned |= alarm;
  const bool enables_turned = settings_.on(Setting::enable_polarity) || inverted(model_->polarity.enable, 0);
  const auto on = static_cast<std::uint32_t>(terminals_.enables) ^ (enables_turned ? all_enables : 0);
  const std::uint32_t out = static_cast<std::uint32_t>(outputs()) ^ turned;
  return (out & all_outputs) | (on & all_enables) << model_->outputs;
}

void Controller::set_outputs(std::int64_t value) {
  const std::int64_t changed = std::exchange(terminals_.outputs, value) ^ value;
  for (int n = 1; trace != nullptr && n <= model_->outputs; ++n) {
    if ((changed >> (n - 1) & 1) == 0) continue;
    const std::string name = "output " + std::to_string(n);
    const bool on = (value >> (n - 1) & 1) != 0;
    note_event(name + (on ? " on" : " off"));
    trace->back().io = name, trace->back().level = on ? 1 : 0;
  }
}

void Controller::set_output(int number, bool on) {
  const std::int64_t bit = std::int64_t{1} << (number - 1);
  set_outputs(on ? terminals_.outputs | bit : terminals_.outputs & ~bit);
}

void Controller::set_enables(std::int64_t value) {
  bring_up_to_date();
  terminals_.enables = value;
  if (load_needs_power_) hold_loads();
}

void Controller::load_needs_power() {
  load_needs_power_ = true;
  hold_loads();
}

void Controller::jam(int a, bool on) {
  axes_[ix(a)].jammed_by_hand = on;
  hold_loads();
}

/// Holds a load that cannot move: jammed, or without motor power on a bench that needs it.
void Controller::hold_loads() {
  for (int a = 0; a < axes(); ++a) {
    Axis& axis = axes_[ix(a)];
    const bool held = axis.jammed_by_hand || (load_needs_power_ && (terminals_.enables >> a & 1) == 0);
    if (held == axis.plant.jammed()) continue;
    axis.plant.jam(held);
    bench_changed(a);
  }
}

void Controller::set_enable(int number, bool on) {
  const std::int64_t bit = std::int64_t{1} << (number - 1);
  set_enables(on ? terminals_.enables | bit : terminals_.enables & ~bit);
}

// --- latch -------------------------------------------------------------------------------------------------

void Controller::arm_latch(int a, bool on) {
  Latch& latch = axes_[ix(a)].latch;
  if (on)
    latch = {1, 0, 0};
  else
    latch.state = 0;
}

void Controller::operate_input(int number, bool active) {
  bring_up_to_date();
  std::array<bool, most_axes> before{};
  for (int a = 0; a < axes(); ++a) before[ix(a)] = latch_input_active(a);
  const std::uint32_t bit = 1u << (number - 1);
  terminals_.inputs = active ? terminals_.inputs | bit : terminals_.inputs & ~bit;
  if (!powered_) return;
  for (int a = 0; a < axes(); ++a) {
    Axis& axis = axes_[ix(a)];
    if (before[ix(a)] || !latch_input_active(a) || axis.latch.state != 1) continue;
    axis.latch = {2, position(a), encoder(a)};
    note_event("the latch of axis " + letter(a) + " caught " + std::to_string(axis.latch.pulses));
  }
}

void Controller::operate_alarm(int a, bool on) {
  bring_up_to_date();
  axes_[ix(a)].alarm_operated = on;
  if (powered_) replan(a);
}

void Controller::bench_changed(int a) {
  if (!powered_) return;
  update_sync(a);
  if (moving(a))
    replan(a);
  else
    settle_loop(a);
}

// --- sync outputs ------------------------------------------------------------------------------------------

bool Controller::sync_condition(int a, std::int64_t encoder) const {
  const std::int64_t at = settings_.get(Setting::sync_position, a);
  switch (settings_.get(Setting::sync_condition, a)) {
    case 1: return encoder == at;
    case 2: return encoder < at;
    default: return encoder > at;
  }
}

void Controller::sync_on(int a) {
  bring_up_to_date();
  SyncOutput& s = axes_[ix(a)].sync;
  if (s.open) end_sync_pulse(a);
  s = SyncOutput();
  s.state = 1;
  s.seen = axes_[ix(a)].encoder();
  update_sync(a);
  replan(a);
}

void Controller::sync_off(int a) {
  bring_up_to_date();
  if (axes_[ix(a)].sync.open) end_sync_pulse(a);
  axes_[ix(a)].sync = SyncOutput();
}

void Controller::update_sync(int a) {
  SyncOutput& s = axes_[ix(a)].sync;
  if (s.state == 0) return;
  const std::int64_t seen = std::exchange(s.seen, axes_[ix(a)].encoder());
  const bool held = std::exchange(s.holds, sync_condition(a, s.seen));
  const bool equal = settings_.get(Setting::sync_condition, a) == 1;
  const std::int64_t at = settings_.get(Setting::sync_position, a);
  // A step of several counts over the position counts too.
  const bool stepped_over =
      equal && !s.holds && !held && ((seen < at && s.seen > at) || (seen > at && s.seen < at));
  const Duration width = std::chrono::milliseconds(equal ? settings_.get(Setting::sync_width, a) : 0);
  if ((s.holds && !held) || stepped_over) {
    s.state = 2;
    TriggerPulse pulse;
    pulse.at = now_, pulse.output = model_->sync_outputs[ix(a)], pulse.width = width;
    for (int i = 0; i < axes(); ++i) pulse.position[ix(i)] = Steps(position(i));
    trigger_pulses.push_back(pulse);
    s.open = !stepped_over || width > Duration{};
    s.pulse_until = width > Duration{} ? now_ + width : Instant{};
  } else if (held && !s.holds && s.open && width == Duration{}) {
    end_sync_pulse(a);
  }
}

/// The newest pulse of that output has ended.
void Controller::end_sync_pulse(int a) {
  SyncOutput& s = axes_[ix(a)].sync;
  s.open = false;
  const int output = model_->sync_outputs[ix(a)];
  std::size_t looked = 0;
  for (auto p = trigger_pulses.rbegin(); p != trigger_pulses.rend() && looked < most_open_pulses;
       ++p, ++looked)
    if (p->output == output) {
      p->width = now_ - p->at;
      break;
    }
}

void Controller::watch_sync(Motion& m, int a, int way, Sign load) {
  const Axis& axis = axes_[ix(a)];
  if (axis.sync.state == 0 || axis.counts_per_pulse == 0) return;
  const bool rising = (load == Sign::plus) == (axis.counts_per_pulse > 0);
  const std::int64_t at = settings_.get(Setting::sync_position, a), here = axis.encoder();
  const std::int64_t most =
      std::abs(m.track.offset(ix(a), m.track.next_turn(m.applied)) - m.track.offset(ix(a), m.applied));
  // The condition changes where the counter reaches the position, and where it leaves it.
  const std::int64_t threshold = rising ? (here < at ? at : at + 1) : (here > at ? at : at - 1);
  if (rising ? here >= threshold : here <= threshold) return;
  m.mark(a, way, axis.first_turn(most, [&](std::int64_t turns) {
    const std::int64_t there = axis.encoder_at(axis.plant.load_after(load, turns));
    return rising ? there >= threshold : there <= threshold;
  }));
}

}  // namespace hw::arcus
