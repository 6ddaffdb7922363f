#include "core/sequence/places_before.h"

#include <algorithm>
#include <cmath>

#include "core/base/index.h"
#include "core/sequence/arc_shape.h"
#include "core/sequence/steps_in.h"

namespace hw::sequence {
namespace {

using AxisBits = std::array<bool, max_axes>;

constexpr int most_in_loops = 200'000;  // steps; more are not walked through

bool same(double a, double b) { return std::fabs(a - b) <= 1e-9 * (1 + std::fabs(a) + std::fabs(b)); }
bool same(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? same(*a, *b) : !a && !b;
}

/// Whether a shifted axis has an arc that is not a full circle: its passes are not evenly shifted.
bool turns(const StepList& steps, const AxisBits& shifts) {
  return std::any_of(steps.begin(), steps.end(), [&](const Step& step) {
    if (step.skipped) return false;
    if (const auto* loop = std::get_if<Repeat>(&step.body)) return turns(loop->steps, shifts);
    const auto* arc = std::get_if<Arc>(&step.body);
    return arc && std::fmod(arc->degrees, 360) != 0 &&
           (shifts[ix(arc->plane.right)] || shifts[ix(arc->plane.up)]);
  });
}

class Walk {
 public:
  Walk(const Sequence& of, const Places& begin, const AxisBits& until_homed = {})
      : at(begin), of_(of), until_homed_(until_homed) {}

  void over(const StepList& steps, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to && i < steps.size(); ++i) {
      if (steps[i].skipped) continue;
      in_loops_ += depth_ > 0;
      std::visit([this](const auto& body) { take(body); }, steps[i].body);
    }
  }
  void over(const StepList& steps) { over(steps, 0, steps.size()); }
  /// Axes that the steps shift are elsewhere in each pass.
  void into(const StepList& steps) {
    Walk round = *this;
    round.reach_ = nullptr;
    round.over(steps);
    forget_all_but(round.at);
  }
  /// Records the reach from here on.
  void reach_into(Reach* reach) {
    if (never_comes_) return;
    reach_ = reach;
    for (int a = 0; a < max_axes; ++a)
      if (at[ix(a)]) comes(a, *at[ix(a)]);
  }
  Places at;

 private:
  template <class Other>
  void take(const Other&) {}  // moves nothing
  void take(const Speed& s) {
    if (s.speeds.high != 0) speeds_.high = s.speeds.high;
    if (s.speeds.low != 0) speeds_.low = s.speeds.low;
    if (s.speeds.ramp_ms != 0) speeds_.ramp_ms = s.speeds.ramp_ms;
  }
  void take(const Move& m) {
    for (int a = 0; a < max_axes; ++a) {
      const auto& to = m.to[ix(a)];
      const auto& from = at[ix(a)];
      if (to) goes(a, !m.relative ? to : from ? std::optional(*from + *to) : std::nullopt);
    }
  }
  void take(const Arc& arc) {
    const auto [right, up] = arc.plane;
    const auto x = at[ix(right)], y = at[ix(up)];
    if (!x || !y) return forget(right), forget(up);
    const ArcReach bulge = reach_of(arc, *x, *y);
    comes(right, bulge.left), comes(right, bulge.right), comes(up, bulge.below), comes(up, bulge.above);
    const auto [end_x, end_y] = end_of(arc, *x, *y);
    goes(right, end_x), goes(up, end_y);
  }
  void take(const SpeedStairs& s) {
    for (const SpeedStairs::Stair& stair : s.stairs) comes(s.axis, stair.until);
    goes(s.axis, s.stop_at);
  }
  void take(const Jog& jog) { forget(jog.axis); }
  void take(const Home& home) {
    forget(home.axis);
    if (home.axis >= 0 && home.axis < max_axes && until_homed_[ix(home.axis)]) unasked_[ix(home.axis)] = true;
  }
  /// The input may never start the homing, so the present count may still hold afterwards.
  void take(const MoveOnInput& move) {
    if (move.kind == MoveOnInput::Kind::move) comes(move.axis, move.to);
    forget(move.axis);
  }
  void take(const Stop& stop) {
    for (int a = 0; a < max_axes; ++a)
      if (stop.axis < 0 || stop.axis == a) forget(a);
  }
  void take(const Contour& c) {
    const auto [right, up] = c.plane;
    if (const auto way = sets_off(c))
      comes(right, c.x - way->first * c.lead_in), comes(up, c.y - way->second * c.lead_in);
    goes(right, c.x), goes(up, c.y);
    over(c.steps);
    if (c.ends_ramped) run_on(c);
  }
  /// Continues in the last direction; with an unknown ramp, about as far as its lead-in.
  void run_on(const Contour& c) {
    const auto [right, up] = c.plane;
    const auto end = end_of(c);
    if (!end) return forget(right), forget(up);
    const auto by = runs_on_by(c, speeds_);
    const double way = by.value_or(c.lead_in);
    goes(right, end->x + end->dx * way), goes(up, end->y + end->dy * way);
    if (!by) forget(right), forget(up);
  }
  void take(const Custom&) {
    for (int a = 0; a < max_axes; ++a) forget(a);
  }
  void take(const Pen& pen) {
    if (in_routine_) return;  // refused by all writers
    in_routine_ = true;
    over(pen.down ? of_.pen_down : of_.pen_up);
    in_routine_ = false;
  }

  // ---- loops: after the first, each pass is shifted by the same distance, so that the last one reaches
  // furthest.
  void take(const Repeat& loop) {
    ++depth_;
    if (loop.times == 1)
      over(loop.steps);
    else
      go_round(loop);
    --depth_;
    if (loop.times == 0) reach_ = nullptr, never_comes_ = true;
  }
  void go_round(const Repeat& loop) {
    const Places first = at;
    over(loop.steps);
    if (came_back(first)) return;
    const Places second = at;
    if (in_loops_ < most_in_loops) over(loop.steps);
    if (in_loops_ >= most_in_loops) return forget_all_but(first);
    if (came_back(second) || loop.times == 2) return;
    AxisBits shifts{};
    for (std::size_t a = 0; a < at.size(); ++a) shifts[a] = !same(at[a], second[a]);
    if (turns(loop.steps, shifts)) return go_all_round(loop, shifts);
    for (std::size_t a = 0; a < at.size(); ++a)
      if (at[a] && second[a] && shifts[a]) move_on(loop, static_cast<int>(a), *at[a] - *second[a]);
    if (loop.times > 0) over(loop.steps);
  }
  /// Goes to the begin of the last pass.
  void move_on(const Repeat& loop, int axis, double by) {
    if (loop.times > 0) return goes(axis, *at[ix(axis)] + by * (loop.times - 3.0));
    if (asks(axis)) (by < 0 ? reach_->endless_minus : reach_->endless_plus)[ix(axis)] = true;
    forget(axis);
  }
  /// Runs through all remaining passes, if not too many.
  void go_all_round(const Repeat& loop, const AxisBits& shifts) {
    for (int n = 2; n < loop.times && in_loops_ < most_in_loops; ++n) over(loop.steps);
    for (int a = 0; a < max_axes; ++a)
      if (shifts[ix(a)] && (loop.times == 0 || in_loops_ >= most_in_loops)) forget(a);
  }
  void forget_all_but(const Places& still) {
    for (int a = 0; a < max_axes; ++a)
      if (!same(at[ix(a)], still[ix(a)])) forget(a);
  }
  [[nodiscard]] bool came_back(const Places& to) const {
    return std::equal(at.begin(), at.end(), to.begin(),
                      [](const auto& a, const auto& b) { return same(a, b); });
  }

  void goes(int axis, std::optional<double> to) {
    if (axis < 0 || axis >= max_axes) return;
    if (to) comes(axis, *to);
    at[ix(axis)] = to;
  }
  void forget(int axis) { goes(axis, std::nullopt); }
  [[nodiscard]] bool asks(int axis) const {
    return reach_ && axis >= 0 && axis < max_axes && !unasked_[ix(axis)];
  }
  void comes(int axis, double to) {
    if (!asks(axis)) return;
    auto &least = reach_->least[ix(axis)], &greatest = reach_->greatest[ix(axis)];
    least = least ? std::min(*least, to) : to;
    greatest = greatest ? std::max(*greatest, to) : to;
  }

  const Sequence& of_;
  AxisBits until_homed_, unasked_{};
  Speeds speeds_;
  bool in_routine_ = false;
  bool never_comes_ = false;  ///< after an endless loop
  int depth_ = 0, in_loops_ = 0;
  Reach* reach_ = nullptr;  ///< null: not recording
};

bool moves(const Step& step, int axis) {
  const auto names = [axis](const auto& body) {
    using Body = std::decay_t<decltype(body)>;
    const auto in = [axis](const Plane& plane) { return plane.right == axis || plane.up == axis; };
    if constexpr (std::is_same_v<Body, Move>) return body.to[ix(axis)].has_value();
    if constexpr (std::is_same_v<Body, Arc> || std::is_same_v<Body, Contour>) return in(body.plane);
    if constexpr (std::is_same_v<Body, Jog> || std::is_same_v<Body, Home> ||
                  std::is_same_v<Body, MoveOnInput> || std::is_same_v<Body, SpeedStairs>)
      return body.axis == axis;
    return false;
  };
  return std::visit(names, step.body);
}
bool is_moved_in(const StepList& steps, const Sequence& of, int axis) {
  return std::any_of(steps.begin(), steps.end(), [&](const Step& step) {
    if (step.skipped) return false;
    if (const auto* loop = std::get_if<Repeat>(&step.body)) return is_moved_in(loop->steps, of, axis);
    const auto* pen = std::get_if<Pen>(&step.body);
    return moves(step, axis) || (pen && is_moved_in(pen->down ? of.pen_down : of.pen_up, {}, axis));
  });
}

}  // namespace

Places places_before(const Sequence& sequence, const StepPath& step) {
  Walk walk(sequence, {});
  const StepList* list = &sequence.steps;
  for (std::size_t level = 0; list && level < step.size(); ++level) {
    walk.over(*list, 0, step[level]);
    if (level + 1 == step.size() || step[level] >= list->size()) break;
    const Step& outer = (*list)[step[level]];
    list = steps_in(outer);
    if (const auto* contour = std::get_if<Contour>(&outer.body))
      walk.at[ix(contour->plane.right)] = contour->x, walk.at[ix(contour->plane.up)] = contour->y;
    if (const auto* loop = std::get_if<Repeat>(&outer.body); loop && loop->times != 1) walk.into(loop->steps);
  }
  return walk.at;
}

std::vector<Reach> reaches_between(const Sequence& sequence, const std::vector<std::size_t>& bounds,
                                   const Places& begin, const AxisBits& until_homed) {
  std::vector<Reach> all(bounds.empty() ? 0 : bounds.size() - 1);
  Walk walk(sequence, begin, until_homed);
  if (!all.empty()) walk.over(sequence.steps, 0, bounds.front());
  for (std::size_t i = 0; i < all.size(); ++i) {
    walk.reach_into(&all[i]);
    walk.over(sequence.steps, bounds[i], bounds[i + 1]);
  }
  return all;
}

bool is_moved(const Sequence& sequence, int axis) { return is_moved_in(sequence.steps, sequence, axis); }
bool is_moved_by_tool(const Sequence& sequence, int axis) {
  return is_moved_in(sequence.pen_up, {}, axis) || is_moved_in(sequence.pen_down, {}, axis);
}

}  // namespace hw::sequence
