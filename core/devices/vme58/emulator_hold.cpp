// Functions that watch an encoder: slip and stall (ES, TN), position maintenance of step axes (HN, HV, HG,
// HD), tracking (ET).
#include <algorithm>
#include <cmath>

#include "core/base/rounded_steps.h"
#include "core/devices/vme58/emulator_motion.h"

namespace hw::vme58 {

using What = MotionEvent::What;

namespace {

constexpr double at_least_s = 0.001, at_most_s = 1e8;  // between two corrections

}  // namespace

void Motion::watch_error(int a) {
  MotionAxis& x = axes_[ix(a)];
  if (!x.fitting.encoder) return;
  const bool in_place = in_position(a);
  if (in_place && !std::exchange(x.was_in_position, in_place)) note_event(What::ready, a);
  x.was_in_position = in_place;
  const bool beyond = x.watches_slip() && std::abs(x.error()) > x.settings.slip_tolerance;
  if (beyond && !std::exchange(x.slipped, true)) slipped(a);
  x.slipped = beyond;
  schedule_correction(a);
}

void Motion::slipped(int a) {
  MotionAxis& x = axes_[ix(a)];
  note_event(What::slipped, a);
  if (!x.settings.slip_kills) return;
  x.settings.holding = false;
  if (Run* r = run_of(a)) finish(*r, End::cut);
  if (x.servo()) x.loop.close(false);
  x.was_holding = false;
  schedule_updates();
}

/// The speed of a correction is the error times HG, at most HV. Its pulses move only the load: the command
/// register stays. They come one by one, or in groups of one millisecond.
void Motion::schedule_correction(int a) {
  MotionAxis& x = axes_[ix(a)];
  const AxisSettings& s = x.settings;
  const bool wanted = !x.servo() && s.holding && x.run < 0 && !s.tracking && !x.plant.jammed() &&
                      std::abs(x.error()) > s.hold_deadband && s.encoder_counts_per_ratio != 0;
  const double pulses =
      wanted ? static_cast<double>(x.error()) * s.motor_counts_per_ratio / s.encoder_counts_per_ratio : 0;
  const double speed = std::min(s.hold_velocity, std::abs(pulses) * s.hold_gain);
  const std::int64_t left = rounded_steps(pulses).value;
  const Sign way = left < 0 ? Sign::minus : Sign::plus;
  if (left == 0 || speed <= 0 || (s.limits_on && x.plant.limit_operated(way))) {
    x.correct_at.reset();
    return;
  }
  if (x.correct_at) return;
  const double lasts = std::clamp(1 / speed, at_least_s, at_most_s);
  const auto most = std::max<std::int64_t>(static_cast<std::int64_t>(speed * lasts + 1e-9), 1);
  x.correct_by = factor(way) * std::min(most, std::abs(left));
  x.correct_at = now_ + from_seconds(lasts);
}

void Motion::correct(int a) {
  MotionAxis& x = axes_[ix(a)];
  x.correct_at.reset();
  const Sign way = x.correct_by < 0 ? Sign::minus : Sign::plus;
  std::int64_t count = std::abs(x.correct_by);
  if (x.settings.limits_on)
    if (const auto until = x.plant.turns_until_limit(way)) count = std::min(count, *until);
  x.turn_load(static_cast<int>(factor(way)), count);
  watch_error(a);
}

/// One count of the encoder input is one count of the axis (decision M81), up to a limit switch.
void Motion::track(int a, std::int64_t counts) {
  MotionAxis& x = axes_[ix(a)];
  x.zero += counts;
  if (x.off() || x.run >= 0 || counts == 0) return;
  const Sign way = counts < 0 ? Sign::minus : Sign::plus;
  std::int64_t count = std::abs(counts);
  if (x.settings.limits_on)
    if (const auto until = x.plant.turns_until_limit(way); until && *until <= count) {
      count = *until;
      note_event(What::limit_hit, a);
    }
  if (count > 0) x.turn(static_cast<int>(factor(way)), count);
}

}  // namespace hw::vme58
