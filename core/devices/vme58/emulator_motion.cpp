// Motion at one speed, from rest to rest, without switches and encoders: enough for queues to be tried.
#include "core/devices/vme58/emulator_motion.h"

#include <algorithm>
#include <cmath>

#include "core/base/index.h"

namespace hw::vme58 {

struct Motion::State {
  struct Axis {
    AxisSettings settings;
    double from = 0, target = 0, speed = 0;
    Instant began{}, ends{};
    bool on_the_way = false, jogs = false;
    std::int64_t at = 0;
    Sign way = Sign::plus;
  };
  const Variant* variant;
  std::array<Axis, most_axes> axes{};
  BoardSettings board;
  Instant now{};
  std::vector<MotionEvent> events;

  Axis& operator[](int a) { return axes[ix(a)]; }
  double place(const Axis& a) const {
    if (a.jogs) return a.from + a.speed * seconds(now - a.began);
    if (!a.on_the_way) return static_cast<double>(a.at);
    const double whole = seconds(a.ends - a.began);
    return whole <= 0 ? a.target
                      : a.from + (a.target - a.from) * std::min(1.0, seconds(now - a.began) / whole);
  }
  void tell(MotionEvent::What what, int axis) { events.push_back({what, axis, false}); }
  void rest(int axis, std::int64_t at) {
    Axis& a = axes[ix(axis)];
    const bool moved = a.on_the_way || a.jogs;
    a.at = at, a.on_the_way = a.jogs = false;
    if (moved) tell(MotionEvent::What::rested, axis);
  }
  void go(int axis, std::int64_t to, double speed) {
    Axis& a = axes[ix(axis)];
    a.from = place(a), a.target = static_cast<double>(to), a.began = now, a.jogs = false, a.on_the_way = true;
    a.ends = now + from_seconds(std::abs(a.target - a.from) / std::max(speed, 1.0));
    if (a.target != a.from) a.way = a.target < a.from ? Sign::minus : Sign::plus;
    tell(MotionEvent::What::began, axis);
  }
};

Motion::Motion(const Variant& variant) : state_(std::make_unique<State>()) {
  state_->variant = &variant;
  reset();
}
Motion::Motion(const Motion& o) : state_(std::make_unique<State>(*o.state_)) {}
Motion& Motion::operator=(const Motion& o) {
  if (this != &o) state_ = std::make_unique<State>(*o.state_);
  return *this;
}
Motion::Motion(Motion&&) noexcept = default;
Motion& Motion::operator=(Motion&&) noexcept = default;
Motion::~Motion() = default;

Instant Motion::now() const { return state_->now; }

std::optional<Instant> Motion::next_event() const {
  std::optional<Instant> next;
  for (const auto& a : state_->axes)
    if (a.on_the_way && (!next || a.ends < *next)) next = a.ends;
  return next;
}

void Motion::advance_to(Instant to) {
  state_->now = to;
  for (int a = 0; a < most_axes; ++a)
    if ((*state_)[a].on_the_way && (*state_)[a].ends <= to)
      state_->rest(a, static_cast<std::int64_t>((*state_)[a].target));
}

void Motion::take_events(std::vector<MotionEvent>& sink) {
  sink.insert(sink.end(), state_->events.begin(), state_->events.end());
  state_->events.clear();
}

void Motion::reset() {
  state_->axes = {};
  state_->board = BoardSettings();
  for (int a = 0; a < most_axes; ++a)
    (*state_)[a].settings.holding = state_->variant->fitting(a).kind == AxisKind::servo;
}

const AxisSettings& Motion::settings(int axis) const { return (*state_)[axis].settings; }
AxisSettings& Motion::settings(int axis) { return (*state_)[axis].settings; }
const BoardSettings& Motion::board() const { return state_->board; }
BoardSettings& Motion::board() { return state_->board; }
void Motion::changed(int) {}

bool Motion::start(const Move& move) {
  double longest = 0;
  std::array<std::int64_t, most_axes> to{};
  for (int a = 0; a < most_axes; ++a) {
    const auto& goal = move.goal[ix(a)];
    if (!goal) continue;
    to[ix(a)] = goal->counts + (goal->relative ? position(a) : 0);
    if (std::llabs(to[ix(a)]) > position_max || !settings(a).holding) return false;
    const double way = std::abs(static_cast<double>(to[ix(a)] - position(a)));
    longest = std::max(longest, way / std::max(settings(a).velocity, 1.0));
  }
  for (int a = 0; a < most_axes; ++a)
    if (move.goal[ix(a)]) {
      const double way = std::abs(static_cast<double>(to[ix(a)] - position(a)));
      state_->go(a, to[ix(a)], longest > 0 ? way / longest : 1);
    }
  return true;
}

bool Motion::jog(int axis, double velocity) {
  auto& a = (*state_)[axis];
  if (velocity == 0) return state_->rest(axis, position(axis)), true;
  const bool begins = !a.jogs;
  a.from = state_->place(a), a.began = state_->now, a.speed = velocity, a.jogs = true;
  a.way = velocity < 0 ? Sign::minus : Sign::plus;
  if (begins) state_->tell(MotionEvent::What::began, axis);
  return true;
}

bool Motion::home(int axis, const HomeOrder& order) {
  if (order.kill) return jog(axis, static_cast<double>(factor(order.way)) * settings(axis).velocity);
  load_position(axis, order.position);
  return true;
}
void Motion::remainder(int axis, std::int64_t divisor) { load_position(axis, position(axis) % divisor); }
void Motion::set_direction(int axis, Sign way) { (*state_)[axis].way = way; }
bool Motion::move_velocity(int axis, std::int64_t to, double velocity) {
  if ((to < position(axis) ? Sign::minus : Sign::plus) != direction(axis)) return false;
  return state_->go(axis, to, velocity), true;
}
bool Motion::stop_at(int axis, std::int64_t to) {
  return state_->go(axis, to, settings(axis).velocity), true;
}
bool Motion::play(const Contour& contour) {
  for (int a = 0; a < most_axes; ++a)
    if (contour.has(a)) state_->go(a, contour.start[ix(a)], state_->board.contour_velocity);
  return true;
}
void Motion::notify_at(int, std::int64_t) {}

void Motion::stop(int axis) { state_->rest(axis, position(axis)); }
void Motion::kill(int axis) { state_->rest(axis, position(axis)); }
void Motion::keep_velocity(int axis) {
  if (occupied(axis)) jog(axis, static_cast<double>(factor(direction(axis))) * velocity(axis));
}
bool Motion::force_position(int axis, std::int64_t to) { return stop_at(axis, to); }
void Motion::load_position(int axis, std::int64_t position) {
  auto& a = (*state_)[axis];
  const double by = static_cast<double>(position) - state_->place(a);
  a.from += by, a.target += by, a.at = position;
}

std::int64_t Motion::position(int axis) const { return std::llround(state_->place((*state_)[axis])); }
std::int64_t Motion::encoder(int axis) const { return position(axis); }
double Motion::velocity(int axis) const {
  const auto& a = (*state_)[axis];
  if (a.jogs) return std::abs(a.speed);
  return a.on_the_way ? std::abs(a.target - a.from) / std::max(seconds(a.ends - a.began), 1e-9) : 0;
}
Sign Motion::direction(int axis) const { return (*state_)[axis].way; }
bool Motion::moving(int axis) const { return (*state_)[axis].on_the_way || (*state_)[axis].jogs; }
bool Motion::occupied(int axis) const { return (*state_)[axis].on_the_way; }
bool Motion::in_position(int) const { return true; }
bool Motion::limit_active(int) const { return false; }
bool Motion::home_active(int axis) const { return settings(axis).home_active_high; }
bool Motion::encoder_home_active(int) const { return false; }

Result<> Motion::place(int, const AxisPlace&) { return {}; }
void Motion::operate_limit(int, Sign, bool) {}
void Motion::operate_home(int, bool) {}
void Motion::jam(int, bool) {}
void Motion::slip(int, std::int64_t) {}
void Motion::look(BenchView&) const {}

}  // namespace hw::vme58
