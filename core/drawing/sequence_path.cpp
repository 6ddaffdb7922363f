#include "core/drawing/sequence_path.h"

#include <array>
#include <cmath>

#include "core/base/index.h"
#include "core/drawing/contour_path.h"
#include "core/drawing/placing.h"
#include "core/sequence/arc_shape.h"
#include "core/sequence/chords.h"

namespace hw::drawing {
namespace {

constexpr double chord_of_radius = 1e-4;

class Walk {
  using Places = std::array<double, max_axes>;

 public:
  explicit Walk(const SequenceAxes& axes) : axes_(axes), at_(axes.begin) {}

  void steps(const sequence::StepList& list, int source) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].skipped) continue;
      source_ = source < 0 ? static_cast<int>(i) : source;
      std::visit([this](const auto& body) { take(body); }, list[i].body);
    }
  }
  ToolPath path;

 private:
  template <class Other>
  void take(const Other&) {}  // goes nowhere
  void take(const sequence::Pen& pen) { tool_on_ = pen.down; }
  void take(const sequence::Repeat& loop) { steps(loop.steps, source_); }
  void take(const sequence::Move& m) {
    Places to = at_;
    for (std::size_t a = 0; a < to.size(); ++a)
      if (m.to[a]) to[a] = m.relative ? to[a] + *m.to[a] : *m.to[a];
    go(to);
  }
  void take(const sequence::Arc& a) {
    const Point from{at_[ix(a.plane.right)], at_[ix(a.plane.up)]};
    if (axes_.chord > 0) return take_as_chords(a, from);
    const double radius = std::hypot(from.x - a.x, from.y - a.y);
    const auto [end_x, end_y] = sequence::end_of(a, from.x, from.y);
    const Curve curve{Curve::Kind::arc, from, {end_x, end_y}, {a.x, a.y}, a.degrees};
    const auto go_on = [&](Point to) { go(in_plane(a.plane, to)); };
    if (radius > 0) chords(curve, radius * chord_of_radius, go_on);
  }
  void take(const sequence::SpeedStairs& s) {
    Places to = at_;
    to[ix(s.axis)] = s.stop_at;
    go(to);
  }
  void take_as_chords(const sequence::Arc& a, Point from) {
    const sequence::Chords chords(from.x - a.x, from.y - a.y, a.degrees, axes_.chord);
    for (int n = 1; n <= chords.count(); ++n) {
      const auto [dx, dy] = chords.end(n);
      go(in_plane(a.plane, {a.x + dx, a.y + dy}));
    }
  }
  void take(const sequence::Contour& c) {
    const ToolPath part = contour_path(c, {1, 1});
    const auto place = [&](Point3 p) { return in_plane(c.plane, {p.x, p.y}); };
    for (const ToolPath::Run& run : part.runs)
      for (std::size_t i = run.first + 1; i < run.first + run.size; ++i)
        path.go(seen(place(part.points[i - 1])), seen(place(part.points[i])), run.tool_on, source_);
    if (!part.points.empty()) at_ = place(part.points.back());
  }
  void go(const Places& to) {
    const Point3 a = seen(at_), b = seen(to);
    if (a != b) path.go(a, b, tool_on_, source_);
    at_ = to;
  }
  [[nodiscard]] Places in_plane(const sequence::Plane& plane, Point p) const {
    Places to = at_;
    to[ix(plane.right)] = p.x, to[ix(plane.up)] = p.y;
    return to;
  }
  [[nodiscard]] Point3 seen(const Places& at) const {
    const auto on = [&at](int axis) { return axis < 0 ? 0 : at[static_cast<std::size_t>(axis)]; };
    return {on(axes_.right) * axes_.scale.x, on(axes_.up) * axes_.scale.y, on(axes_.third) * axes_.scale.z};
  }

  const SequenceAxes axes_;
  Places at_;
  bool tool_on_ = false;
  int source_ = -1;
};

bool has_pen(const sequence::StepList& list) {
  for (const sequence::Step& step : list) {
    if (std::holds_alternative<sequence::Pen>(step.body)) return true;
    const auto* loop = std::get_if<sequence::Repeat>(&step.body);
    if (loop && has_pen(loop->steps)) return true;
  }
  return false;
}

}  // namespace

ToolPath sequence_path_in(const sequence::Sequence& sequence, const SequenceAxes& axes) {
  Walk walk(axes);
  if (!has_pen(sequence.steps)) {  // no tool step: all of it counts as tool on
    sequence::StepList steps = sequence.steps;
    steps.insert(steps.begin(), {sequence::Pen{true}});
    walk.steps(steps, -1);
    for (ToolPath::Run& run : walk.path.runs) --run.source;
    return std::move(walk.path);
  }
  walk.steps(sequence.steps, -1);
  return std::move(walk.path);
}

}  // namespace hw::drawing
