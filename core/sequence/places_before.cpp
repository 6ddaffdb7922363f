#include "core/sequence/places_before.h"

#include <algorithm>

#include "core/base/index.h"
#include "core/sequence/arc_shape.h"
#include "core/sequence/steps_in.h"

namespace hw::sequence {
namespace {

class Walk {
 public:
  explicit Walk(const Sequence& of) : of_(of) {}

  void over(const StepList& steps, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to && i < steps.size(); ++i)
      if (!steps[i].skipped) std::visit([this](const auto& body) { take(body); }, steps[i].body);
  }
  void over(const StepList& steps) { over(steps, 0, steps.size()); }
  /// What they move stands elsewhere in each round.
  void into(const StepList& steps) {
    Walk round(of_);
    round.over(steps);
    for (std::size_t a = 0; a < at.size(); ++a)
      if (round.moved_[a]) forget(static_cast<int>(a));
  }
  /// How far they come from where they stand now on.
  void reach_into(Reach* reach) {
    reach_ = reach;
    for (int a = 0; a < max_axes; ++a)
      if (at[ix(a)]) comes(a, *at[ix(a)]);
  }
  Places at;

 private:
  template <class Other>
  void take(const Other&) {}  // moves nothing
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
  void take(const Home& home) { forget(home.axis); }
  void take(const MoveOnInput& move) {
    if (move.kind == MoveOnInput::Kind::move) goes(move.axis, move.to);
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
    if (c.ends_ramped) forget(right), forget(up);  // it runs on along its last direction
  }
  void take(const Custom&) {
    for (int a = 0; a < max_axes; ++a) forget(a);
  }
  void take(const Pen& pen) {
    if (in_routine_) return;  // no writer takes that
    in_routine_ = true;
    over(pen.down ? of_.pen_down : of_.pen_up);
    in_routine_ = false;
  }
  void take(const Repeat& loop) {
    if (loop.times != 1) into(loop.steps);
    over(loop.steps);
  }
  void goes(int axis, std::optional<double> to) {
    if (axis < 0 || axis >= max_axes) return;
    if (to) comes(axis, *to);
    at[ix(axis)] = to;
    moved_[ix(axis)] = true;
  }
  void forget(int axis) { goes(axis, std::nullopt); }
  void comes(int axis, double to) {
    if (!reach_) return;
    auto &least = reach_->least[ix(axis)], &greatest = reach_->greatest[ix(axis)];
    least = least ? std::min(*least, to) : to;
    greatest = greatest ? std::max(*greatest, to) : to;
  }

  const Sequence& of_;
  std::array<bool, max_axes> moved_{};
  bool in_routine_ = false;
  Reach* reach_ = nullptr;  ///< null: nobody asks
};

}  // namespace

Places places_before(const Sequence& sequence, const StepPath& step) {
  Walk walk(sequence);
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

std::vector<Reach> reaches_between(const Sequence& sequence, const std::vector<std::size_t>& bounds) {
  std::vector<Reach> all(bounds.empty() ? 0 : bounds.size() - 1);
  Walk walk(sequence);
  if (!all.empty()) walk.over(sequence.steps, 0, bounds.front());
  for (std::size_t i = 0; i < all.size(); ++i) {
    walk.reach_into(&all[i]);
    walk.over(sequence.steps, bounds[i], bounds[i + 1]);
  }
  return all;
}

}  // namespace hw::sequence
