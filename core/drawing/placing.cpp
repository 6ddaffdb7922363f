#include "core/drawing/placing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/drawing/near_points.h"
#include "core/sequence/chords.h"

namespace hw::drawing {
namespace {

using namespace sequence;

Affine affine_of(const Placing& p, const Box& box) {
  Affine to{p.mirrored_x ? -p.scale : p.scale, 0, 0, p.mirrored_y ? -p.scale : p.scale, 0, 0};
  if (p.swapped) to = Affine{0, 1, 1, 0, 0, 0}.after(to);
  Point zero = p.point;
  if (p.origin == Placing::Origin::as_drawn) zero = {};
  if (p.origin == Placing::Origin::lower_left) {
    Box turned;
    for (const Point corner : {box.low, box.high, Point{box.low.x, box.high.y}, Point{box.high.x, box.low.y}})
      turned.add(to(corner));
    to.e = -turned.low.x, to.f = -turned.low.y;
    return to;
  }
  const Point at = to(zero);
  to.e = -at.x, to.f = -at.y;
  return to;
}

Move move_to(Point p, const Speeds& own) {
  Move m;
  m.to[0] = p.x, m.to[1] = p.y;
  if (own != Speeds{}) m.own = own;
  return m;
}

/// Whether all steps of a routine switch outputs that a contour can switch.
bool within_contours(const StepList& routine, const std::vector<int>& outputs) {
  return !routine.empty() && std::all_of(routine.begin(), routine.end(), [&](const Step& step) {
    const auto* output = std::get_if<Output>(&step.body);
    return output && std::find(outputs.begin(), outputs.end(), output->output) != outputs.end();
  });
}

class Draw {
 public:
  Draw(const Tool& tool, Sequence& sequence) : tool_(tool), s_(sequence) {
    on_the_way_ = tool.curve_mode == CurveMode::contours &&
                  within_contours(s_.pen_down, tool.contour_outputs) &&
                  within_contours(s_.pen_up, tool.contour_outputs);
  }
  void begin() {
    if (tool_.travel != Speeds{}) add(Speed{tool_.travel});
    add(Pen{false});
  }
  void frame(const Box& box) {
    for (const Point corner :
         {box.low, Point{box.high.x, box.low.y}, box.high, Point{box.low.x, box.high.y}, box.low})
      travel(corner);
  }
  void chain(const Chain& c) {
    const std::vector<Curve> curves = distinct(c);
    if (on_the_way_ && !curves.empty()) return contours(curves);
    travel(c.begin());
    add(Pen{true});
    if (!curves.empty()) {
      if (tool_.curve_mode == CurveMode::contours)
        contours(curves);
      else
        along(curves);
      add(WaitMotion{});
    }
    add(Pen{false});
  }

 private:
  void add(Step::Body body) { s_.steps.push_back({std::move(body)}); }
  /// The curves that the machine can resolve: lines that end on another step than they begin on, and arcs
  /// that differ from such a line.
  [[nodiscard]] std::vector<Curve> distinct(const Chain& c) const {
    std::vector<Curve> curves;
    Point at = c.begin();
    for (Curve curve : c.curves) {
      curve.from = at;
      if (is_straight(curve)) curve = {Curve::Kind::line, at, curve.to, {}, 0};
      if (curve.kind == Curve::Kind::line && same_step(at, curve.to)) continue;
      at = curve.to;
      curves.push_back(curve);
    }
    return curves;
  }
  [[nodiscard]] bool is_straight(const Curve& arc) const {
    const double radius = std::hypot(arc.from.x - arc.centre.x, arc.from.y - arc.centre.y);
    const double quarter = std::sin(arc.degrees / 720 * std::numbers::pi);  // of its angle
    return 2 * radius * quarter * quarter <= std::max(tool_.chord(), half_step());
  }
  [[nodiscard]] double half_step() const {
    double finest = std::numeric_limits<double>::infinity();
    for (const Axis& axis : s_.axes) finest = std::min(finest, 0.5 / axis.per_unit);
    return s_.axes.empty() ? 0 : finest;
  }
  [[nodiscard]] bool same_step(Point a, Point b) const {
    if (s_.axes.size() < 2) return a == b;
    const auto same = [&](std::size_t axis, double from, double to) {
      return std::round(from * s_.axes[axis].per_unit) == std::round(to * s_.axes[axis].per_unit);
    };
    return same(0, a.x, b.x) && same(1, a.y, b.y);
  }
  void travel(Point to) {
    if (tool_.curve_mode == CurveMode::stairs)
      single(to, tool_.travel);
    else
      add(move_to(to, tool_.travel));
    add(WaitMotion{});
    at_ = to;
  }
  /// One axis, then the other.
  void single(Point to, const Speeds& own) {
    Move first = move_to(to, own), second = first;
    first.to[1].reset(), second.to[0].reset();
    if (to.x != at_.x || !at_known_) add(first);
    if (to.y != at_.y || !at_known_) add(second);
    at_ = to, at_known_ = true;
  }
  void along(const std::vector<Curve>& curves) {
    for (const Curve& curve : curves) {
      if (curve.kind == Curve::Kind::arc && tool_.curve_mode == CurveMode::arcs) {
        Arc arc = on_steps(curve);
        if (tool_.cutting != Speeds{}) arc.own = tool_.cutting;
        add(arc);
      } else if (tool_.curve_mode == CurveMode::stairs) {
        chords(curve, tool_.chord(), [this](Point to) { stairs(to); });
      } else {
        chords(curve, tool_.chord(), [this](Point to) { add(move_to(to, tool_.cutting)); });
      }
      at_ = curve.to;
    }
  }
  /// Begins with half a stair, so that the line runs through the middle of the stairs.
  void stairs(Point to) {
    const double dx = to.x - at_.x, dy = to.y - at_.y, length = std::hypot(dx, dy);
    if (dx == 0 || dy == 0) return single(to, tool_.cutting);
    // Corners lie |dx dy| / (2 count length) from the line; they may use the tolerance that chords leave.
    const double beside = tool_.tolerance - tool_.chord();
    const double wanted = std::ceil(std::fabs(dx * dy) / (2 * length * beside));
    const int count = static_cast<int>(std::clamp(wanted, 1.0, 1e6));
    const Point from = at_;
    for (int n = 0; n < count; ++n) {
      single({from.x + dx * (n + 0.5) / count, at_.y}, tool_.cutting);
      single({at_.x, from.y + dy * (n + 1.0) / count}, tool_.cutting);
    }
    single(to, tool_.cutting);
  }
  /// If the tool can be switched during a contour: a lead-in, tool on, the chain, tool off, and a ramp.
  /// Otherwise the chain runs from rest to rest at full speed. A long chain becomes several contours.
  void contours(const std::vector<Curve>& curves) {
    const std::size_t most = ix_of(tool_.contour_pieces);
    for (std::size_t first = 0; first < curves.size(); first += most) {
      Contour part;
      part.x = curves[first].from.x, part.y = curves[first].from.y;
      if (tool_.cutting != Speeds{}) part.own = tool_.cutting;
      if (on_the_way_) {
        part.lead_in = tool_.cutting.high * tool_.cutting.ramp_ms / 2000;
        part.steps = s_.pen_down;
      }
      part.ends_ramped = on_the_way_;
      for (std::size_t n = first; n < std::min(first + most, curves.size()); ++n)
        part.steps.push_back(piece_of(curves[n]));
      if (on_the_way_) part.steps.insert(part.steps.end(), s_.pen_up.begin(), s_.pen_up.end());
      add(std::move(part));
    }
    at_ = curves.back().to;
  }
  [[nodiscard]] Step piece_of(const Curve& curve) const {
    if (curve.kind == Curve::Kind::line) return {move_to(curve.to, {})};
    return {on_steps(curve)};
  }
  /// Controllers need a centre on a whole step. Chooses one nearby with distances to both ends as equal as
  /// possible, so that the arc ends where it should.
  [[nodiscard]] Arc on_steps(const Curve& curve) const {
    Arc arc{curve.centre.x, curve.centre.y, curve.degrees, {}};
    const bool whole = std::fabs(curve.degrees) >= 360;
    if (whole || s_.axes.size() < 2 || s_.axes[0].per_unit != s_.axes[1].per_unit) return arc;
    const double steps = s_.axes[0].per_unit;
    const auto rounded = [steps](Point p) { return Point{std::round(p.x * steps), std::round(p.y * steps)}; };
    const Point from = rounded(curve.from), to = rounded(curve.to), near = rounded(curve.centre);
    constexpr int around = 2;
    constexpr double weight_of_shift = 0.05;
    double least = std::numeric_limits<double>::infinity();
    Point best = near;
    for (int dx = -around; dx <= around; ++dx)
      for (int dy = -around; dy <= around; ++dy) {
        const Point centre{near.x + dx, near.y + dy};
        const double beside_end = distance(centre, from) - distance(centre, to);
        const double shift = distance(centre, {curve.centre.x * steps, curve.centre.y * steps});
        const double worth = beside_end * beside_end + weight_of_shift * shift * shift;
        if (worth < least) least = worth, best = centre;
      }
    const double begin = std::atan2(from.y - best.y, from.x - best.x);
    const double turn = (std::atan2(to.y - best.y, to.x - best.x) - begin) / std::numbers::pi * 180;
    arc.x = best.x / steps, arc.y = best.y / steps;
    arc.degrees = turn + 360 * std::round((curve.degrees - turn) / 360);
    return arc;
  }
  static std::size_t ix_of(int n) { return static_cast<std::size_t>(std::max(n, 1)); }

  const Tool& tool_;
  Sequence& s_;
  bool on_the_way_ = false, at_known_ = false;
  Point at_;
};

}  // namespace

Affine place(std::vector<Chain>& chains, const Placing& placing) {
  const Affine to = affine_of(placing, box_of(chains));
  const bool turned = to.a * to.d - to.b * to.c < 0;
  for (Chain& chain : chains)
    for (Curve& c : chain.curves) {
      c.from = to(c.from), c.to = to(c.to), c.centre = to(c.centre);
      if (turned) c.degrees = -c.degrees;
    }
  return to;
}

Box box_of(const std::vector<Chain>& chains) {
  Drawing all;
  for (const Chain& c : chains) all.paths.push_back({c.curves});
  return box_of(all);
}

void chords(const Curve& curve, double tolerance, const std::function<void(Point)>& put) {
  if (curve.kind == Curve::Kind::arc) {
    const Chords chords(curve.from.x - curve.centre.x, curve.from.y - curve.centre.y, curve.degrees,
                        tolerance);
    for (int n = 1; n < chords.count(); ++n) {
      const auto [dx, dy] = chords.end(n);
      put({curve.centre.x + dx, curve.centre.y + dy});
    }
  }
  put(curve.to);
}

std::vector<std::size_t> draw_chains(const std::vector<Chain>& chains, const Tool& tool, Sequence& sequence) {
  Draw draw(tool, sequence);
  draw.begin();
  std::vector<std::size_t> begins;
  begins.reserve(chains.size());
  for (const Chain& chain : chains) {
    begins.push_back(sequence.steps.size());
    draw.chain(chain);
  }
  return begins;
}

void draw_frame(const Box& box, const Tool& tool, Sequence& sequence) {
  Draw draw(tool, sequence);
  draw.begin();
  draw.frame(box);
}

}  // namespace hw::drawing
