#pragma once
// The motion of a VME58 without its firmware: time from event to event, and what was told on the way.
#include <string>
#include <utility>
#include <vector>

#include "core/devices/vme58/emulator_motion.h"

namespace hw::vme58 {

inline constexpr int X = 0, Y = 1, Z = 2, T = 3;
using What = MotionEvent::What;

struct Reported {
  Instant at;
  MotionEvent event;
  std::int64_t position;  ///< of that axis, then
};

class Stage {
 public:
  explicit Stage(std::string_view variant = "8S") : motion(*find_variant(variant)) {}

  Motion motion;
  std::vector<Reported> reported;

  void listen() {
    std::vector<MotionEvent> events;
    motion.take_events(events);
    for (const MotionEvent& e : events) reported.push_back({motion.now(), e, motion.position(e.axis)});
  }
  /// Up to a moment; everything that is due happens at its own time.
  void until(Instant end) {
    listen();
    for (auto next = motion.next_event(); next && *next <= end; next = motion.next_event()) {
      motion.advance_to(std::max(*next, motion.now()));
      listen();
    }
    motion.advance_to(end);
    listen();
  }
  void wait(double s) { until(motion.now() + from_seconds(s)); }
  /// Until nothing is due any more, or for so long.
  void settle(double most_s = 1000) {
    listen();
    const Instant end = motion.now() + from_seconds(most_s);
    for (auto next = motion.next_event(); next && *next <= end; next = motion.next_event()) {
      motion.advance_to(*next);
      listen();
    }
  }
  [[nodiscard]] const Reported* find(What what, int axis = 0) const {
    for (const Reported& t : reported)
      if (t.event.what == what && t.event.axis == axis) return &t;
    return nullptr;
  }
  [[nodiscard]] int count(What what, int axis = 0) const {
    int n = 0;
    for (const Reported& t : reported) n += t.event.what == what && t.event.axis == axis;
    return n;
  }

  void speeds(int axis, double vl, double ac, double vb = 0) {
    AxisSettings& s = motion.settings(axis);
    s.velocity = vl, s.acceleration = ac, s.base_velocity = vb;
    motion.changed(axis);
  }
  bool move(std::vector<std::pair<int, std::int64_t>> goals, bool relative = false) {
    Move m;
    for (const auto& [axis, counts] : goals) m.goal[ix(axis)] = AxisGoal{counts, relative};
    return motion.start(m);
  }
  void travel(int axis, std::int64_t minus, std::int64_t plus) {
    AxisPlace p;
    p.minus = Steps(minus), p.plus = Steps(plus);
    (void)motion.place(axis, p);
  }
  void home_zone(int axis, std::int64_t from, std::int64_t to, std::int64_t index_every = 0) {
    AxisPlace p;
    p.home_from = Steps(from), p.home_to = Steps(to);
    if (index_every > 0) p.index_every = Steps(index_every);
    (void)motion.place(axis, p);
  }
};

}  // namespace hw::vme58
