// Joystick control of the PMX (manual ch. 6; decisions AMB-080 to AMB-082): the voltage of AI1 to AI4 sets
// speed and direction of X to U. The stick is read every 10 ms while the speed changes, by the stick or by
// the place between two soft limits; else never.
//
//   speed |  max
//         |     \____          between the inner and the outer soft limit the speed allowed falls to nothing
//         +------inner--outer--- position
#include <algorithm>
#include <cmath>

#include "core/devices/arcus/emulator_controller.h"

namespace hw::arcus {

using motion::Path;
using motion::Profile;

namespace {

constexpr Duration update = std::chrono::milliseconds(10);

}  // namespace

void Controller::operate_analog(int number, std::int32_t millivolts) {
  bring_up_to_date();
  terminals_.analog[ix(number - 1)] = millivolts;
  if (powered_ && number <= axes() && joystick_on(number - 1)) schedule_joystick();
}

void Controller::schedule_joystick() {
  if (joystick_.due && *joystick_.due > now_) return;
  joystick_.due = Instant((now_.time_since_epoch() / update + 1) * update);
}

/// Signed speed that the stick asks for here, the soft limits included.
double Controller::joystick_target(int a) const {
  const auto jv = [&](int group) { return settings_.get(Setting::joystick_values, 4 * group + a); };
  const auto jl = [&](int n) { return settings_.get(Setting::joystick_limits, 4 * a + n); };
  const Axis& axis = axes_[ix(a)];
  if (!joystick_on(a) || axis.plus_error || axis.minus_error || axis.alarm_error) return 0;
  const std::int64_t high = settings_.get(Setting::joystick_max, a),
                     low = settings_.get(Setting::joystick_min, a);
  const std::int64_t middle = (high - low) / 2 + low, off = terminals_.analog[ix(a)] - middle;
  const std::int64_t band = jv(2), reach = (off > 0 ? high - middle : middle - low) - band;
  if (std::abs(off) <= band || reach <= 0) return 0;
  const auto top = static_cast<double>(jv(0));
  double speed = top * std::min(static_cast<double>(std::abs(off) - band) / static_cast<double>(reach), 1.0);
  if (jl(0) < jl(1) && jl(1) < jl(2) && jl(2) < jl(3)) {
    const std::int64_t outer = off > 0 ? jl(3) : jl(0), inner = off > 0 ? jl(2) : jl(1);
    const std::int64_t room = off > 0 ? outer - axis.pulses : axis.pulses - outer;
    if (room <= 0) return 0;
    const double part = static_cast<double>(room) / static_cast<double>(std::abs(outer - inner));
    speed = std::min(speed, std::max(top * std::min(part, 1.0), 1.0));
  }
  return off > 0 ? speed : -speed;
}

/// Between its inner and outer soft limit, on its way out: the speed falls with each reading.
bool Controller::joystick_slows(int a) const {
  const auto jl = [&](int n) { return settings_.get(Setting::joystick_limits, 4 * a + n); };
  if (motion_of(a) == nullptr || !(jl(0) < jl(1) && jl(1) < jl(2) && jl(2) < jl(3))) return false;
  return joystick_.speed[ix(a)] > 0 ? axes_[ix(a)].pulses >= jl(2) : axes_[ix(a)].pulses <= jl(1);
}

/// At the outer soft limit, on its way out: the speed is zero there (figure 6.10).
bool Controller::joystick_at_end(int a) const {
  const auto jl = [&](int n) { return settings_.get(Setting::joystick_limits, 4 * a + n); };
  if (!(jl(0) < jl(1) && jl(1) < jl(2) && jl(2) < jl(3))) return false;
  const double speed = joystick_.speed[ix(a)];
  return speed > 0 ? axes_[ix(a)].pulses >= jl(3) : axes_[ix(a)].pulses <= jl(0);
}

void Controller::joystick_tick() {
  joystick_.due.reset();
  for (int a = 0; a < axes(); ++a)
    if (joystick_on(a) || joystick_.speed[ix(a)] != 0) joystick_turn(a);
}

/// Per reading of the stick, the speed approaches its target by at most the largest change.
void Controller::joystick_turn(int a) {
  const double target = joystick_target(a), now = joystick_.speed[ix(a)];
  const auto change = static_cast<double>(settings_.get(Setting::joystick_values, 4 + a));
  double next = change > 0 ? std::clamp(target, now - change, now + change) : target;
  if (target == 0 && !joystick_on(a)) next = 0;
  if (next * now < 0) next = 0;  // through rest
  joystick_.speed[ix(a)] = next;
  Motion* m = motion_of(a);
  if (m != nullptr && m->kind != MotionKind::joystick) return;
  if (next == 0) {
    if (m != nullptr) finish(*m, End::cut);
  } else if (m != nullptr && next != now) {
    const double from = m->profile.distance(now_);
    continue_by(*m, Profile::constant(now_, from, Pps(std::abs(next)), Profile::endless));
  } else if (m == nullptr) {
    const Path path = Path::along(ix(a), next < 0 ? Sign::minus : Sign::plus, Profile::endless);
    begin(MotionKind::joystick, 1u << a, path, Profile::constant(now_, 0, Pps(std::abs(next)), path.steps()),
          order(a));
    if (motion_of(a) == nullptr) joystick_.speed[ix(a)] = 0;  // into a switch
  }
  if (target != joystick_.speed[ix(a)] || joystick_slows(a)) schedule_joystick();
}

void Controller::joystick_stops(int a) {
  joystick_.speed[ix(a)] = 0;
  if (Motion* m = motion_of(a)) finish(*m, End::cut);
  schedule_joystick();
}

}  // namespace hw::arcus
