// The buffered moves of the PMX (manual ch. 6; decisions AMB-075 to AMB-078): up to 36 straight segments of
// X, Y and Z, each at its own speed along the path. With IACC=1 the speed changes inside a segment, in ACC
// ms.
#include <algorithm>

#include "core/devices/arcus/emulator_controller.h"

namespace hw::arcus {

using motion::Path;
using motion::Profile;

namespace {

constexpr unsigned xyz = 0b111;

}  // namespace

int Controller::buffer_free() const { return model_->buffer_places - static_cast<int>(buffer_.queue.size()); }

bool Controller::buffer_has_loop() const { return closed(0) || closed(1) || closed(2); }

Refusal Controller::buffer_on() {
  if (buffer_has_loop()) return Refusal::unknown;
  // A segment still running since BF has the first place.
  if (!buffer_.on) buffer_.start = buffer_.end = 0, buffer_.used = !buffer_.queue.empty();
  buffer_.on = true;
  return Refusal::none;
}

/// The running segment ends like a last one; the rest is dropped.
void Controller::buffer_off() {
  buffer_.on = false;
  if (buffer_.queue.size() <= 1) return;
  buffer_.queue.resize(1);
  buffer_.end = buffer_.start;
  bring_up_to_date();
  for (Motion& m : motions_)
    if (m.active && m.kind == MotionKind::buffered && !m.stopping) {
      const Pps now(m.profile.speed(now_).value * m.track.pulses_per_step());
      continue_by(m, segment_profile(m.track, buffer_.queue.front(), now, m.profile.distance(now_), true));
    }
}

Refusal Controller::buffer_move(const Segment& segment) {
  if (!buffer_.on) return Refusal::unknown;
  for (int a = 0; a < 3; ++a)
    if (in_error(a) || alarm_active(a))
      if (const Refusal r = refuses_motion(1u << a); r != Refusal::none && r != Refusal::moving) return r;
  if (!buffer_.running)
    if (const Refusal r = refuses_motion(xyz); r != Refusal::none) return r;
  if (buffer_has_loop()) return Refusal::unknown;
  if (buffer_free() == 0) return Refusal::buffer_full;
  bring_up_to_date();
  const bool was_last = buffer_.queue.size() == 1;
  if (std::exchange(buffer_.used, true)) buffer_.end = (buffer_.end + 1) % model_->buffer_places;
  if (buffer_.queue.empty()) buffer_.start = buffer_.end;
  buffer_.queue.push_back(segment);
  if (!buffer_.running) {
    const std::int64_t low = settings_.get(Setting::low_speed);
    next_segment(Pps(static_cast<double>(std::min(low, segment.speed))));
    return Refusal::none;
  }
  if (!was_last || !settings_.on(Setting::buffer_accel)) return Refusal::none;
  for (Motion& m : motions_)  // the running segment need no longer slow down
    if (m.active && m.kind == MotionKind::buffered && !m.stopping &&
        m.profile.phase(now_) != motion::Phase::decelerating) {
      const Pps now(m.profile.speed(now_).value * m.track.pulses_per_step());
      continue_by(m, segment_profile(m.track, buffer_.queue.front(), now, m.profile.distance(now_), false));
    }
  return Refusal::none;
}

Profile Controller::segment_profile(const Path& path, const Segment& s, Pps now, double from,
                                    bool last) const {
  const double scale = path.pulses_per_step();
  const double speed = static_cast<double>(s.speed) / scale;
  if (!settings_.on(Setting::buffer_accel)) return Profile::constant(now_, from, Pps(speed), path.steps());
  SpeedOrder o;
  o.high = s.speed, o.low = std::min(settings_.get(Setting::low_speed), s.speed);
  o.accel_ms = settings_.get(Setting::accel);
  const double ms = static_cast<double>(adjusted_ms(*model_, o, o.accel_ms));
  const double v0 = now.value / scale, base = static_cast<double>(o.low) / scale;
  const double change = std::max(std::abs(speed - v0), 1e-3) * 1000 / ms;
  const double down = std::max(speed - base, 1e-3) * 1000 / ms;
  const motion::Ramp ramp(change, last ? down : change, Pps(last ? base : speed));
  if (last) return Profile::approach(now_, from, Pps(v0), Pps(speed), change, ramp, path.steps());
  return Profile::change(now_, from, Pps(v0), Pps(speed), motion::Ramp(change, change), path.steps());
}

void Controller::next_segment(Pps speed) {
  const Segment& s = buffer_.queue.front();
  buffer_.running = true;
  motion::Offsets way{};
  for (int a = 0; a < 3; ++a) way[ix(a)] = s.to[ix(a)] - position(a);
  const Path path = Path::line(way);
  SpeedOrder by = path_order(xyz);
  by.high = s.speed;
  begin(MotionKind::buffered, xyz, path, segment_profile(path, s, speed, 0, buffer_.queue.size() == 1), by);
}

void Controller::segment_ended(Pps speed) {
  const bool stopped = buffer_.queue.empty();
  if (!stopped) buffer_.queue.pop_front();
  buffer_.running = false;
  if (buffer_.queue.empty()) {
    for (int a = 0; a < 3; ++a) settle_loop(a);
    return;
  }
  buffer_.start = (buffer_.start + 1) % model_->buffer_places;
  next_segment(speed);
}

}  // namespace hw::arcus
