#include "core/sequence/places_before.h"

#include <cmath>
#include <numbers>

#include "core/base/index.h"
#include "core/sequence/steps_in.h"

namespace hw::sequence {
namespace {

class Walk {
 public:
  explicit Walk(const Sequence& of) : of_(of) {}

  void over(const StepList& steps, std::size_t count) {
    for (std::size_t i = 0; i < count && i < steps.size(); ++i)
      if (!steps[i].skipped) std::visit([this](const auto& body) { take(body); }, steps[i].body);
  }
  /// What they move stands elsewhere in each round.
  void into(const StepList& steps) {
    Walk round(of_);
    round.over(steps, steps.size());
    for (std::size_t a = 0; a < at.size(); ++a)
      if (round.moved_[a]) forget(static_cast<int>(a));
  }
  Places at;

 private:
  template <class Other>
  void take(const Other&) {}  // moves nothing
  void take(const Move& m) {
    for (std::size_t a = 0; a < at.size(); ++a) {
      if (!m.to[a]) continue;
      moved_[a] = true;
      at[a] = !m.relative ? m.to[a] : at[a] ? std::optional(*at[a] + *m.to[a]) : std::nullopt;
    }
  }
  void take(const Arc& arc) {
    const auto x = at[0], y = at[1];
    forget(0), forget(1);
    if (!x || !y) return;
    const double turn = arc.degrees / 180 * std::numbers::pi, dx = *x - arc.x, dy = *y - arc.y;
    at[0] = arc.x + dx * std::cos(turn) - dy * std::sin(turn);
    at[1] = arc.y + dx * std::sin(turn) + dy * std::cos(turn);
  }
  void take(const Jog& jog) { forget(jog.axis); }
  void take(const Home& home) { forget(home.axis); }
  void take(const MoveOnInput& move) { forget(move.axis); }
  void take(const Stop& stop) {
    for (int a = 0; a < max_axes; ++a)
      if (stop.axis < 0 || stop.axis == a) forget(a);
  }
  void take(const Contour&) { forget(0), forget(1); }
  void take(const Custom&) {
    for (int a = 0; a < max_axes; ++a) forget(a);
  }
  void take(const Pen& pen) {
    if (in_routine_) return;  // no writer takes that
    in_routine_ = true;
    const StepList& steps = pen.down ? of_.pen_down : of_.pen_up;
    over(steps, steps.size());
    in_routine_ = false;
  }
  void take(const Repeat& loop) {
    if (loop.times != 1) into(loop.steps);
    over(loop.steps, loop.steps.size());
  }
  void forget(int axis) {
    if (axis < 0 || axis >= max_axes) return;
    at[ix(axis)].reset();
    moved_[ix(axis)] = true;
  }

  const Sequence& of_;
  std::array<bool, max_axes> moved_{};
  bool in_routine_ = false;
};

}  // namespace

Places places_before(const Sequence& sequence, const StepPath& step) {
  Walk walk(sequence);
  const StepList* list = &sequence.steps;
  for (std::size_t level = 0; list && level < step.size(); ++level) {
    walk.over(*list, step[level]);
    if (level + 1 == step.size() || step[level] >= list->size()) break;
    const Step& outer = (*list)[step[level]];
    list = steps_in(outer);
    if (const auto* contour = std::get_if<Contour>(&outer.body))
      walk.at[0] = contour->x, walk.at[1] = contour->y;
    if (const auto* loop = std::get_if<Repeat>(&outer.body); loop && loop->times != 1) walk.into(loop->steps);
  }
  return walk.at;
}

}  // namespace hw::sequence
