// The effect of hands on one controller, and its lamps (Front p.5, Setup p.7, Troubleshooting p.30).
#include <algorithm>

#include "core/base/index.h"
#include "core/devices/vxm/emulator_box.h"

namespace hw::vxm {
namespace {

/// Lit in the first half of each period.
bool flashes(Duration since, Duration period) { return since % period < period / 2; }

/// The next change of flashes() after `since`.
Duration next_flash(Duration since, Duration period) { return (since / (period / 2) + 1) * (period / 2); }

}  // namespace

void Box::set_line(int line, bool low) {
  Line& l = lines_[ix(line)];
  if (l.low == low) return;
  l.low = low, l.since = now_, l.used = false;
  if (!powered_) return;
  if (buttons_blocked_ && !any_button_low()) {
    buttons_blocked_ = false;  // let go: it starts up now
    powered_at_ = now_;
  }
  if (line == line_in_4 && low && !buttons_blocked_) {
    if (memory_.setup.inputs & inputs_capture) capture();
    if (memory_.setup.inputs & inputs_stop) stop_input();
  }
}

void Box::set_analog(int value) { analog_ = std::clamp(value, analog_min, analog_max); }

/// Switches, jam or load of an axis have changed: the motion under way meets its limit elsewhere.
void Box::plant_changed(int axis) {
  note_closed(axis);
  if (!motion_.active || motion_.axis != axis) return;
  const auto left = turns_until_stop(axis, motion_.sign, motion_.kind == MotionKind::home);
  motion_.limit_at.reset();
  if (left) motion_.limit_at = motion_.applied + *left;
}

int Box::outputs() const { return outputs_ | (pulse_until_ > now_ ? 2 : 0); }

Box::Lamps Box::lamps() const {
  Lamps l;
  if (!powered_) return l;
  const Duration since = now_ - powered_at_;
  l.power = true;
  l.online = online_;
  if (blocked_) {
    l.online = flashes(since, power_flash), l.online_blinks = true;
  } else if (error_ != 0) {
    l.power = l.online = flashes(since, fast_flash);
    l.power_blinks = l.online_blinks = true;
  } else if (buttons_blocked_) {
    l.power = flashes(since, fast_flash), l.power_blinks = true;
  } else if (since < power_lamps) {
    l.online = true;
  } else if (!is_slave_ && since < power_lamps + power_flashes * power_flash) {
    l.power = !flashes(since - power_lamps, power_flash);  // dark first: six flashes are seen
    l.power_blinks = true;
  }
  return l;
}

std::optional<Instant> Box::lamp_event() const {
  if (!powered_) return std::nullopt;
  const Duration since = now_ - powered_at_;
  if (blocked_) return powered_at_ + next_flash(since, power_flash);
  if (error_ != 0 || buttons_blocked_) return powered_at_ + next_flash(since, fast_flash);
  if (since < power_lamps) return powered_at_ + power_lamps;
  if (!is_slave_ && since < power_lamps + power_flashes * power_flash)
    return powered_at_ + power_lamps + next_flash(since - power_lamps, power_flash);
  return std::nullopt;
}

}  // namespace hw::vxm
