// Motors, counters, limit switches, pulses tied to positions (Motor Commands, App. D to F, N).
#include <algorithm>

#include "core/base/index.h"
#include "core/devices/vxm/emulator_box.h"
#include "core/devices/vxm/report.h"

namespace hw::vxm {

using motion::Profile;

namespace {
constexpr std::int64_t most_pulses = 100'000;
}  // namespace

motion::Ramp Box::ramp(int axis) const {
  const double rate = accel_unit * axes_[ix(axis)].accel * (rules_.nf90 ? 2 : 1);
  return {rate, rate};
}

Duration Box::ramp_to_rest(int axis) const {
  return turning(axis) ? from_seconds(motion_.profile.speed(now_).value / ramp(axis).decel) : Duration{};
}

/// Direction of the load; setDM reverses a motor and its limit switches.
Sign Box::physical(int axis, Sign sign) const { return rules_.inverted[ix(axis)] ? -sign : sign; }

/// A home switch is wired to both limit inputs instead of the end switches (App. N): the bench has one, and
/// setL is set for it.
bool Box::home_switch_wired(int axis) const {
  const int mode = memory_.setup.limit_mode[ix(axis)];
  const bool for_homing_only = mode == limits_home_closed || mode == limits_home_open;
  return for_homing_only && axes_[ix(axis)].plant.place().home_from.has_value();
}

/// The switch wired to the limit input on that side of the load is operated, by the load or by hand.
bool Box::switch_operated(int axis, Sign side) const {
  const motion::Plant& plant = axes_[ix(axis)].plant;
  if (plant.limit_by_hand(side) || plant.home_by_hand()) return true;
  return home_switch_wired(axis) ? plant.home_operated() : plant.limit_operated(side);
}

void Box::note_closed(int axis) {
  for (const Sign side : {Sign::minus, Sign::plus})
    if (!switch_operated(axis, side)) axes_[ix(axis)].seen_closed[side == Sign::plus] = true;
}

/// The limit input is active (V30, V69).
bool Box::limit_active(int axis, Sign side) const {
  if (!switch_operated(axis, side)) return false;
  return memory_.setup.limit_mode[ix(axis)] != limits_detect ||
         axes_[ix(axis)].seen_closed[side == Sign::plus];
}

std::optional<std::int64_t> Box::turns_until_stop(int axis, Sign sign, bool homing) const {
  const Axis& a = axes_[ix(axis)];
  const int mode = memory_.setup.limit_mode[ix(axis)];
  const bool for_homing_only = mode == limits_home_closed || mode == limits_home_open;
  if (for_homing_only && !homing) return std::nullopt;
  const Sign way = physical(axis, sign);
  if (limit_active(axis, way)) return 0;
  if (!a.fitted) return std::nullopt;
  if (mode == limits_detect && !a.seen_closed[way == Sign::plus]) return std::nullopt;
  return home_switch_wired(axis) ? a.plant.turns_until_home(way) : a.plant.turns_until_limit(way);
}

bool Box::start_motion(MotionKind kind, int axis, Sign sign, const Profile& profile) {
  const auto limit = turns_until_stop(axis, sign, kind == MotionKind::home);
  motion_ = Motion();
  motion_.kind = kind, motion_.axis = axis, motion_.sign = sign;
  motion_.from = axes_[ix(axis)].counter;
  motion_.profile = profile;
  motion_.limit_at = limit;
  if (limit && *limit == 0) {
    motion_.end = MotionEnd::limit;
    motion_.ended = true;
    tally_.limit_was_hit = true;
    return false;
  }
  motion_.active = true;
  motion_.ended = false;
  return true;
}

void Box::begin_index(int axis, std::int64_t distance, int home) {
  motion_.ended = false;
  if (distance == 0 && home == 0) return;
  const Sign sign = (home != 0 ? home < 0 : distance < 0) ? Sign::minus : Sign::plus;
  std::int64_t steps = home != 0 ? home_give_up_steps : std::abs(distance);
  const bool takes_up = home == 0 && sign == Sign::minus && rules_.backlash > 0;
  if (takes_up) steps += rules_.backlash;
  const Profile profile = Profile::index(now_, steps, Pps(axes_[ix(axis)].speed), ramp(axis));
  start_motion(home != 0 ? MotionKind::home : MotionKind::index, axis, sign, profile);
  motion_.come_back = takes_up ? rules_.backlash : 0;
}

void Box::sync() {
  if (!motion_.active) return;
  std::int64_t done = motion_.profile.steps(now_);
  if (motion_.limit_at) done = std::min(done, *motion_.limit_at);
  const auto slows = motion_.profile.slows_at();
  if (!motion_.slowing_noted && slows && *slows <= now_) {
    std::int64_t at = motion_.profile.steps(*slows);
    if (!motion_.limit_at || at < *motion_.limit_at) {
      note_slowing(*slows, wrap_position(motion_.from + factor(motion_.sign) * at));
      motion_.slowing_noted = true;
    }
  }
  if (done > motion_.applied) turn(motion_.axis, motion_.sign, done - motion_.applied);
}

void Box::turn(int axis, Sign sign, std::int64_t steps) {
  note_pulses(axis, sign, steps);
  motion_.applied += steps;
  apply_turn(axis, sign, steps);
}

void Box::apply_turn(int axis, Sign sign, std::int64_t steps) {
  Axis& a = axes_[ix(axis)];
  const std::int64_t moved = factor(sign) * steps;
  a.counter = wrap_position(a.counter + moved);
  a.comb += moved;
  a.unwrapped += moved;
  a.travelled += steps;
  a.lowest = std::min(a.lowest, a.unwrapped), a.highest = std::max(a.highest, a.unwrapped);
  if (a.fitted) a.plant.turn(physical(axis, sign), steps);
  note_closed(axis);
}

/// Pulses every n steps: the comb lies half a period from where it was laid, the odd step to plus (V82).
///   n = 5:  ... -2 . . . . 3 . . . . 8 ...      n = 4:  ... -2 . . . 2 . . . 6 ...
void Box::note_pulses(int axis, Sign sign, std::int64_t steps) {
  const std::int64_t n = memory_.setup.pulse_every[ix(axis)];
  if (n == 0) return;
  const std::int64_t here = axes_[ix(axis)].comb, first_tooth = n % 2 ? n / 2 + 1 : n / 2;
  const std::int64_t way = factor(sign);
  const auto mod = [n](std::int64_t v) { return (v % n + n) % n; };
  std::int64_t ahead = sign == Sign::plus ? mod(first_tooth - here) : mod(here - first_tooth);
  if (ahead == 0) ahead = n;
  if (ahead > steps) return;
  const std::int64_t count = (steps - ahead) / n + 1;
  if (count > most_pulses) ahead += (count - most_pulses) * n;
  const Duration width = std::chrono::microseconds(10 * memory_.setup.pulse_width);
  for (std::int64_t k = ahead; k <= steps; k += n) {
    Pulse pulse;
    pulse.at = motion_.active ? motion_.profile.time_at(motion_.applied + k) : now_;
    pulse.output = 2, pulse.axis = axis, pulse.width = width;
    pulse.position = wrap_position(axes_[ix(axis)].counter + way * k);
    pulses.push_back(pulse);
    terminals_.outputs.pulse_until(pulse.at + width);
  }
}

std::int32_t Box::counter_at(int axis, Instant t) const {
  if (!motion_.active || motion_.axis != axis) return axes_[ix(axis)].counter;
  std::int64_t done = motion_.profile.steps(t);
  if (motion_.limit_at) done = std::min(done, *motion_.limit_at);
  return wrap_position(motion_.from + factor(motion_.sign) * done);
}

std::optional<Instant> Box::motion_event() const {
  if (!motion_.active) return std::nullopt;
  if (!motion_.limit_at) return motion_.profile.end();
  return std::min(motion_.profile.end(), motion_.profile.time_at(*motion_.limit_at));
}

bool Box::end_motion_if_due() {
  const auto due = motion_event();
  if (!due || *due > now_) return false;
  sync();
  const bool limit = motion_.limit_at && motion_.applied >= *motion_.limit_at;
  if (!limit && !motion_.stopping && motion_.come_back > 0) {  // the second leg of a backlash move (App. F)
    const std::int64_t back = motion_.come_back;
    const Profile profile =
        Profile::index(now_, back, Pps(axes_[ix(motion_.axis)].speed), ramp(motion_.axis));
    start_motion(MotionKind::index, motion_.axis, Sign::plus, profile);
    return true;
  }
  cut_motion(limit ? MotionEnd::limit : motion_.stopping ? MotionEnd::stopped : MotionEnd::done);
  return true;
}

void Box::cut_motion(MotionEnd end) {
  if (!motion_.active) return;
  sync();
  motion_.active = false;
  motion_.end = end;
  motion_.ended = true;
  if (end == MotionEnd::limit) tally_.limit_was_hit = true;
}

/// D, Stop: ramps down at the set rate from the present speed.
void Box::decelerate() {
  if (!motion_.active || motion_.stopping) return;
  sync();
  const auto slows = motion_.profile.slows_at();
  if (slows && *slows <= now_) return;  // already slowing down
  motion_.come_back = 0;
  motion_.stopping = true;
  note_slowing(now_, axes_[ix(motion_.axis)].counter);
  motion_.slowing_noted = true;
  motion_.profile = Profile::stop(now_, motion_.profile.distance(now_), motion_.profile.speed(now_),
                                  ramp(motion_.axis).decel);
}

}  // namespace hw::vxm
