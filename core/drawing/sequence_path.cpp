#include "core/drawing/sequence_path.h"

#include <cmath>
#include <numbers>

#include "core/drawing/contour_path.h"
#include "core/drawing/placing.h"

namespace hw::drawing {
namespace {

constexpr double chord_of_radius = 1e-4;

class Walk {
 public:
  explicit Walk(Point scale) : scale_(scale) {}

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
    const auto to = [&m](std::size_t axis, double from) {
      return !m.to[axis] ? from : m.relative ? from + *m.to[axis] : *m.to[axis];
    };
    go({to(0, at_.x), to(1, at_.y)});
  }
  void take(const sequence::Arc& a) {
    const double radius = std::hypot(at_.x - a.x, at_.y - a.y);
    const Curve curve{Curve::Kind::arc, at_, {}, {a.x, a.y}, a.degrees};
    if (radius > 0) chords(with_end(curve), radius * chord_of_radius, [this](Point to) { go(to); });
  }
  void take(const sequence::Contour& c) {
    const ToolPath part = contour_path(c, scale_);
    for (const ToolPath::Run& run : part.runs)
      for (std::size_t i = run.first + 1; i < run.first + run.size; ++i)
        path.go(part.points[i - 1], part.points[i], run.tool_on, source_);
    if (!part.points.empty()) at_ = {part.points.back().x / scale_.x, part.points.back().y / scale_.y};
  }
  static Curve with_end(Curve curve) {
    const double turn = curve.degrees / 180 * std::numbers::pi;
    const double x = curve.from.x - curve.centre.x, y = curve.from.y - curve.centre.y;
    curve.to = {curve.centre.x + x * std::cos(turn) - y * std::sin(turn),
                curve.centre.y + x * std::sin(turn) + y * std::cos(turn)};
    return curve;
  }
  void go(Point to) {
    if (to != at_) path.go(scaled(at_), scaled(to), tool_on_, source_);
    at_ = to;
  }
  [[nodiscard]] Point scaled(Point p) const { return {p.x * scale_.x, p.y * scale_.y}; }

  const Point scale_;
  Point at_;
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

ToolPath sequence_path(const sequence::Sequence& sequence, Point scale) {
  Walk walk(scale);
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
