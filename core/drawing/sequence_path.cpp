#include "core/drawing/sequence_path.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/drawing/contour_path.h"
#include "core/drawing/placing.h"
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
    const double radius = std::hypot(at_[0] - a.x, at_[1] - a.y);
    if (axes_.chord > 0) return take_as_chords(a);
    const Curve curve{Curve::Kind::arc, {at_[0], at_[1]}, {}, {a.x, a.y}, a.degrees};
    if (radius > 0) chords(with_end(curve), radius * chord_of_radius, [this](Point to) { go(in_plane(to)); });
  }
  void take_as_chords(const sequence::Arc& a) {
    const sequence::Chords chords(at_[0] - a.x, at_[1] - a.y, a.degrees, axes_.chord);
    for (int n = 1; n <= chords.count(); ++n) {
      const auto [dx, dy] = chords.end(n);
      go(in_plane({a.x + dx, a.y + dy}));
    }
  }
  void take(const sequence::Contour& c) {
    const ToolPath part = contour_path(c, {1, 1});
    const auto place = [this](Point3 p) { return in_plane({p.x, p.y}); };
    for (const ToolPath::Run& run : part.runs)
      for (std::size_t i = run.first + 1; i < run.first + run.size; ++i)
        path.go(seen(place(part.points[i - 1])), seen(place(part.points[i])), run.tool_on, source_);
    if (!part.points.empty()) at_ = place(part.points.back());
  }
  static Curve with_end(Curve curve) {
    const double turn = curve.degrees / 180 * std::numbers::pi;
    const double x = curve.from.x - curve.centre.x, y = curve.from.y - curve.centre.y;
    curve.to = {curve.centre.x + x * std::cos(turn) - y * std::sin(turn),
                curve.centre.y + x * std::sin(turn) + y * std::cos(turn)};
    return curve;
  }
  void go(const Places& to) {
    const Point3 a = seen(at_), b = seen(to);
    if (a != b) path.go(a, b, tool_on_, source_);
    at_ = to;
  }
  /// Arcs and contours are of the first two axes.
  [[nodiscard]] Places in_plane(Point p) const {
    Places to = at_;
    to[0] = p.x, to[1] = p.y;
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
  if (!has_pen(sequence.steps)) {  // no tool is spoken of: all of it is work
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
