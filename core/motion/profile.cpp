#include "core/motion/profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hw::motion {
namespace {

constexpr double slowest = 1e-6;     // steps/s; keeps divisions finite
constexpr double longest_s = 3.0e9;  // 95 years: fits in nanoseconds together with a start

double at_least_slow(double v) { return std::max(v, slowest); }

/// `s` rounded up to a nanosecond.
Duration round_up(double s) {
  return Duration(static_cast<Duration::rep>(std::ceil(std::clamp(s, 0.0, longest_s) * 1e9 - 1e-3)));
}

/// Distance of an exponential ramp within `u` seconds of its slow end.
double exponential_way(double v, double a0, double bend, double u) {
  return v * u + a0 / bend * (u + std::expm1(-bend * u) / bend);
}

}  // namespace

/// Law of acceleration: at speed v it is rate * (1 - fall * (v - base)).
struct Profile::Law {
  double rate = 1, base = 0, fall = 0;
  RampShape shape = RampShape::linear;

  Law(const Ramp& ramp, double rate_at_base, double highest)
      : rate(rate_at_base), base(std::max(ramp.start_speed.value, 0.0)), shape(ramp.shape) {
    const double span = std::max(highest, ramp.top.value) - base;
    if (shape != RampShape::parabolic) return;
    if (ramp.truncation > 0 && span > slowest)
      fall = ramp.truncation / span;
    else
      shape = RampShape::linear;
  }
  [[nodiscard]] double rate_at(double v) const { return rate * (1 - fall * (v - base)); }
  /// Distance between two speeds; negative if the second is lower.
  [[nodiscard]] double way(double v0, double v1) const {
    if (fall == 0) return (v1 * v1 - v0 * v0) / (2 * rate);
    const auto integral = [&](double v) {
      const double w = v - base, log = std::log1p(-fall * w);
      return -(w + (1 / fall + base) * log) / (fall * rate);
    };
    return integral(v1) - integral(v0);
  }
  [[nodiscard]] double time(double v0, double v1) const {
    if (fall == 0) return (v1 - v0) / rate;
    return std::log(rate_at(v0) / rate_at(v1)) / (fall * rate);
  }
};

namespace {

/// The highest speed up to `most` whose ramps up and down fit into `way`. Linear ramps have a closed form.
template <class Way>
double peak_within(double way, double least, double most, const Way& up_and_down) {
  if (up_and_down(most) <= way) return most;
  double low = least, high = most;
  for (int i = 0; i < 100 && high - low > 1e-12 * high; ++i) {
    const double middle = (low + high) / 2;
    (up_and_down(middle) <= way ? low : high) = middle;
  }
  return low;
}

}  // namespace

double Profile::Stretch::speed(double u) const {
  switch (shape) {
    case RampShape::half_cosine: return v0 + (v1 - v0) * (1 - std::cos(std::numbers::pi * u / lasts_s)) / 2;
    case RampShape::parabolic:
      if (v1 > v0) return v0 - a0 / bend * std::expm1(-bend * u);
      return v1 - a0 / bend * std::expm1(-bend * (lasts_s - u));
    default: return v0 + u * (a0 + u * bend / 2);
  }
}

double Profile::Stretch::distance(double u) const {
  switch (shape) {
    case RampShape::half_cosine: {
      const double turn = std::numbers::pi / lasts_s;
      return from + u * (v0 + v1) / 2 - (v1 - v0) / (2 * turn) * std::sin(turn * u);
    }
    case RampShape::parabolic:
      if (v1 > v0) return from + exponential_way(v0, a0, bend, u);
      return to - exponential_way(v1, a0, bend, lasts_s - u);
    default: return from + u * (v0 + u * (a0 / 2 + u * bend / 6));
  }
}

void Profile::add_stretch(double lasts_s, double to, double v1, RampShape shape, double a0, double bend) {
  if (count_ == static_cast<int>(stretches_.size())) return;
  stretches_[static_cast<std::size_t>(count_++)] = {time_, lasts_s, distance_, to, v_, v1, shape, a0, bend};
  time_ += lasts_s, distance_ = to, v_ = v1;
}

void Profile::hold(double to) { ramp(to, v_); }

void Profile::ramp(double to, double v1) { ramp(to, v1, Law(Ramp(1, 1), 1, 0)); }

/// Ramps from the present speed to `v1` at `to`; the shape is stretched in time to fit.
void Profile::ramp(double to, double v1, const Law& law) {
  if (to <= distance_) return;
  const double v0 = v_, from = distance_;
  const double lasts = (to - from) / at_least_slow((v0 + v1) / 2);
  const double rate = (v1 - v0) / lasts;
  if (law.shape == RampShape::linear || v0 == v1)
    return add_stretch(lasts, to, v1, RampShape::linear, rate, 0);
  if (law.shape == RampShape::half_cosine) return add_stretch(lasts, to, v1, law.shape, 0, 0);
  if (law.shape == RampShape::parabolic) {
    const double low = std::min(v0, v1), high = std::max(v0, v1);
    const double longer = (to - from) / law.way(low, high);
    const double fits = longer * law.time(low, high);
    return add_stretch(fits, to, v1, law.shape, law.rate_at(low) / longer, law.rate * law.fall / longer);
  }
  // An S: twice the mean acceleration half way, none at both ends. It covers the same distance as the linear
  // ramp.
  const double half = lasts / 2, jerk = 4 * rate / lasts;
  add_stretch(half, from + v0 * half + (v1 - v0) * lasts / 12, (v0 + v1) / 2, law.shape, 0, jerk);
  add_stretch(half, to, v1, law.shape, 2 * rate, -jerk);
}

void Profile::finish(std::int64_t length) {
  length_ = length;
  end_ = start_ + round_up(time_);
}

Profile Profile::index(Instant start, std::int64_t length, Pps slew, const Ramp& ramp) {
  Profile p;
  p.start_ = start;
  const double way = static_cast<double>(std::max<std::int64_t>(length, 0));
  const double base = std::min(std::max(ramp.start_speed.value, 0.0), slew.value);
  const Law up(ramp, ramp.accel, slew.value), down(ramp, ramp.decel, slew.value);
  const double triangle =
      up.fall > 0
          ? peak_within(way, base, slew.value, [&](double v) { return up.way(base, v) + down.way(base, v); })
          : std::sqrt(base * base + 2 * way * ramp.accel * ramp.decel / (ramp.accel + ramp.decel));
  const double peak = at_least_slow(std::min(slew.value, triangle));
  p.v_ = base;
  p.ramp(std::min(up.way(base, peak), way), peak, up);
  const double slows = way - down.way(base, peak);
  if (slows > p.distance_ * (1 + 1e-12)) p.ramp(slows, peak);
  p.ramp(way, base, down);
  p.finish(static_cast<std::int64_t>(way));
  return p;
}

Profile Profile::change(Instant start, double from, Pps now, Pps wanted, const Ramp& ramp, std::int64_t end) {
  Profile p;
  p.start_ = start, p.from_ = p.distance_ = from, p.v_ = now.value;
  const double v0 = now.value, v1 = at_least_slow(wanted.value);
  const Law law(ramp, v1 > v0 ? ramp.accel : ramp.decel, std::max(v0, v1));
  const double way = std::max(static_cast<double>(end) - from, 0.0);
  const double needed = std::abs(law.way(v0, v1));
  if (needed >= way) {
    const double rate = v1 > v0 ? law.rate : -law.rate;
    p.ramp(from + way, std::sqrt(std::max(v0 * v0 + 2 * rate * way, 0.0)));
  } else {
    p.ramp(from + needed, v1, law);
    p.v_ = v1;
    p.hold(static_cast<double>(end));
  }
  p.finish(end);
  return p;
}

Profile Profile::stop(Instant start, double from, Pps now, double decel) {
  const std::int64_t end = std::llround(from + now.value * now.value / (2 * decel));
  Profile p;
  p.start_ = start, p.from_ = p.distance_ = from, p.v_ = now.value;
  // Less than half a step left: the step under way is not made.
  const bool here = static_cast<double>(end) <= from;
  if (!here) p.ramp(static_cast<double>(end), 0);
  p.finish(here ? static_cast<std::int64_t>(std::floor(from)) : end);
  return p;
}

Profile Profile::stop_within(Instant start, double from, Pps now, std::int64_t length) {
  Profile p;
  p.start_ = start, p.from_ = p.distance_ = from, p.v_ = now.value;
  const auto end = static_cast<std::int64_t>(std::llround(from)) + std::max<std::int64_t>(length, 0);
  p.ramp(static_cast<double>(end), 0);
  p.finish(end);
  return p;
}

Profile Profile::approach(Instant start, double from, Pps now, Pps wanted, double change_down,
                          const Ramp& ramp, std::int64_t end) {
  Profile p;
  p.start_ = start, p.from_ = p.distance_ = from, p.v_ = now.value;
  const double v0 = now.value, to = static_cast<double>(end), way = std::max(to - from, 0.0);
  const double highest = std::max(v0, wanted.value), base = std::min(ramp.start_speed.value, highest);
  const Law up(ramp, ramp.accel, highest), down(ramp, ramp.decel, highest), slow(ramp, change_down, highest);
  const auto way_down = [&](double v) { return std::max(down.way(base, v), 0.0); };
  double v1 = at_least_slow(wanted.value);
  if (v1 > v0) {
    if (up.fall > 0)
      v1 = peak_within(way, v0, v1, [&](double v) { return up.way(v0, v) + way_down(v); });
    else if (up.way(v0, v1) + way_down(v1) > way)
      v1 = std::sqrt(
          std::max((2 * way * ramp.accel * ramp.decel + v0 * v0 * ramp.decel + base * base * ramp.accel) /
                       (ramp.accel + ramp.decel),
                   0.0));
    v1 = std::max(v1, v0);
    if (v1 > v0) p.ramp(from + std::min(up.way(v0, v1), way), v1, up);
  } else if (v1 < v0) {
    const double slowing = slow.way(v1, v0);
    if (slowing + way_down(v1) <= way)
      p.ramp(from + slowing, v1, slow);
    else
      v1 = v0;  // no room: slows straight down to the end
  }
  if (to - way_down(v1) > p.distance_) p.ramp(to - way_down(v1), v1);
  p.ramp(to, std::min(base, p.v_), down);
  p.finish(end);
  return p;
}

Profile Profile::ramp_down(Instant start, double from, Pps now, const Ramp& ramp) {
  const double v = now.value, base = std::min(ramp.start_speed.value, v);
  const Law down(ramp, ramp.decel, v);
  const std::int64_t end = std::llround(from + down.way(base, v));
  Profile p;
  p.start_ = start, p.from_ = p.distance_ = from, p.v_ = v;
  const bool here = v <= base || static_cast<double>(end) <= from;
  if (!here) p.ramp(static_cast<double>(end), base, down);
  p.finish(here ? static_cast<std::int64_t>(std::floor(from)) : end);
  return p;
}

Profile Profile::constant(Instant start, double from, Pps speed, std::int64_t end) {
  Profile p;
  p.start_ = start, p.from_ = p.distance_ = from, p.v_ = at_least_slow(speed.value);
  p.hold(static_cast<double>(end));
  p.finish(end);
  return p;
}

Phase Profile::phase(Instant t) const {
  if (t >= end_) return Phase::ended;
  const Stretch* s = at(std::max(since_start(t), 0.0));
  if (s == nullptr) return Phase::ended;
  if (s->v1 > s->v0) return Phase::accelerating;
  return s->v1 < s->v0 ? Phase::decelerating : Phase::constant;
}

const Profile::Stretch* Profile::at(double t) const {
  for (int i = 0; i < count_; ++i) {
    const Stretch& s = stretches_[static_cast<std::size_t>(i)];
    if (t < s.begin_s + s.lasts_s || i + 1 == count_) return &s;
  }
  return nullptr;
}

double Profile::distance(Instant t) const {
  if (t >= end_) return count_ > 0 ? distance_ : static_cast<double>(length_);
  const double since = std::max(since_start(t), 0.0);
  const Stretch* s = at(since);
  if (s == nullptr) return from_;
  const double u = std::clamp(since - s->begin_s, 0.0, s->lasts_s);
  return std::min(s->distance(u), s->to);
}

Pps Profile::speed(Instant t) const {
  if (t >= end_) return Pps(0);
  const double since = std::max(since_start(t), 0.0);
  const Stretch* s = at(since);
  if (s == nullptr) return Pps(0);
  const double u = std::clamp(since - s->begin_s, 0.0, s->lasts_s);
  return Pps(std::max(s->speed(u), 0.0));
}

Pps Profile::final_speed() const { return Pps(v_); }

/// Time within the stretch at distance `d`.
double Profile::Stretch::time_at(double d) const {
  if (shape == RampShape::linear) {
    const double rate = (v1 - v0) / lasts_s;
    if (rate >= 0) {  // from the beginning, or from the end while slowing: keeps precision near rest
      const double way = d - from;
      return 2 * way / (v0 + std::sqrt(v0 * v0 + 2 * rate * way));
    }
    const double rest = to - d;
    return lasts_s - (rest > 0 ? 2 * rest / (v1 + std::sqrt(v1 * v1 - 2 * rate * rest)) : 0.0);
  }
  double low = 0, high = lasts_s, u = lasts_s * std::clamp((d - from) / (to - from), 0.0, 1.0);
  for (int i = 0; i < 60 && high - low > 1e-13; ++i) {  // bounded Newton
    const double off = distance(u) - d;
    (off > 0 ? high : low) = u;
    const double v = speed(u), next = v > slowest ? u - off / v : low;
    const double guess = next > low && next < high ? next : (low + high) / 2;
    if (std::abs(guess - u) < 1e-13) return guess;
    u = guess;
  }
  return u;
}

Instant Profile::time_at(std::int64_t k) const {
  const double d = static_cast<double>(k);
  if (d <= from_) return start_;
  if (k >= length_) return end_;
  for (int i = 0; i < count_; ++i) {
    const Stretch& s = stretches_[static_cast<std::size_t>(i)];
    if (d > s.to && i + 1 < count_) continue;
    return std::min(start_ + round_up(s.begin_s + s.time_at(d)), end_);
  }
  return end_;
}

std::int64_t Profile::steps(Instant t) const {
  if (t >= end_) return length_;
  if (t < start_) return static_cast<std::int64_t>(std::floor(from_));
  auto k = static_cast<std::int64_t>(std::floor(distance(t)));
  const auto first = static_cast<std::int64_t>(std::floor(from_));
  while (k > first && time_at(k) > t) --k;  // at most one step: keeps steps() and time_at() consistent
  while (k < length_ && time_at(k + 1) <= t) ++k;
  return k;
}

std::optional<Instant> Profile::slows_at() const {
  if (count_ == 0 || v_ > slowest) return std::nullopt;
  const Stretch& last = stretches_[static_cast<std::size_t>(count_ - 1)];
  if (last.v1 >= last.v0) return std::nullopt;
  return std::min(start_ + round_up(last.begin_s), end_);
}

}  // namespace hw::motion
