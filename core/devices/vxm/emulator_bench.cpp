// The effect of the bench on one controller, and its lamps (Front p.5, Setup p.7, Troubleshooting p.30).
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
  Line& l = terminals_.lines[ix(line)];
  if (l.low == low) return;
  l.low = low, l.since = now_, l.used = false;
  if (!supply_.on) return;
  if (supply_.buttons_held && !any_button_low()) {
    supply_.buttons_held = false;  // let go: it starts up now
    supply_.since = now_;
  }
  if (line == line_in_4 && low && !supply_.buttons_held) {
    if (memory_.setup.inputs & inputs_capture) capture();
    if (memory_.setup.inputs & inputs_stop) stop_input();
  }
}

void Box::set_analog(int value) { terminals_.analog.set(value); }

/// Switches, jam or load of an axis have changed: the motion under way meets its limit elsewhere.
void Box::plant_changed(int axis) {
  note_closed(axis);
  if (!motion_.active || motion_.axis != axis) return;
  const auto left = turns_until_stop(axis, motion_.sign, motion_.kind == MotionKind::home);
  motion_.limit_at.reset();
  if (left) motion_.limit_at = motion_.applied + *left;
}

int Box::outputs() const { return terminals_.outputs.at(now_); }

Box::Lamps Box::lamps() const {
  Lamps l;
  if (!supply_.on) return l;
  const Duration since = now_ - supply_.since;
  l.power = true;
  l.online = host_.mode.online;
  if (supply_.deaf) {
    l.online = flashes(since, power_flash), l.online_blinks = true;
  } else if (state_.error != 0) {
    l.power = l.online = flashes(since, fast_flash);
    l.power_blinks = l.online_blinks = true;
  } else if (supply_.buttons_held) {
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
  if (!supply_.on) return std::nullopt;
  const Duration since = now_ - supply_.since;
  if (supply_.deaf) return supply_.since + next_flash(since, power_flash);
  if (state_.error != 0 || supply_.buttons_held) return supply_.since + next_flash(since, fast_flash);
  if (since < power_lamps) return supply_.since + power_lamps;
  if (!is_slave_ && since < power_lamps + power_flashes * power_flash)
    return supply_.since + power_lamps + next_flash(since - power_lamps, power_flash);
  return std::nullopt;
}

}  // namespace hw::vxm
