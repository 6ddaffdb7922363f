#include "core/drawing/placing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// All its steps switch outputs that can be switched on the way.
bool within_contours(const StepList& routine, const std::vector<int>& outputs) {
  return !routine.empty() && std::all_of(routine.begin(), routine.end(), [&](const Step& step) {
    const auto* output = std::get_if<Output>(&step.body);
    return output && std::find(outputs.begin(), outputs.end(), output->output) != outputs.end();
  });
}

class Draw {
 public:
  Draw(const Tool& tool, Sequence& sequence) : tool_(tool), s_(sequence) {
    on_the_way_ = tool.going == Going::contours && within_contours(s_.pen_down, tool.contour_outputs) &&
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
    if (on_the_way_ && is_long(c)) return contours(c);
    travel(c.begin());
    add(Pen{true});
    if (is_long(c)) {
      if (tool_.going == Going::contours)
        contours(c);
      else
        along(c);
      add(WaitMotion{});
    }
    add(Pen{false});
  }

 private:
  void add(Step::Body body) { s_.steps.push_back({std::move(body)}); }
  static bool is_long(const Chain& c) {
    return std::any_of(c.curves.begin(), c.curves.end(), [](const Curve& k) { return k.length() > 0; });
  }
  void travel(Point to) {
    if (tool_.going == Going::stairs)
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
  void along(const Chain& c) {
    for (const Curve& curve : c.curves) {
      if (curve.length() == 0) continue;
      if (curve.kind == Curve::Kind::arc && tool_.going == Going::arcs) {
        Arc arc{curve.centre.x, curve.centre.y, curve.degrees, {}};
        if (tool_.cutting != Speeds{}) arc.own = tool_.cutting;
        add(arc);
      } else if (tool_.going == Going::stairs) {
        chords(curve, tool_.tolerance / 2, [this](Point to) { stairs(to); });
      } else {
        chords(curve, tool_.tolerance, [this](Point to) { add(move_to(to, tool_.cutting)); });
      }
      at_ = curve.to;
    }
  }
  /// Half a step first, so that the line goes through the middle of the stairs.
  void stairs(Point to) {
    const double dx = to.x - at_.x, dy = to.y - at_.y, length = std::hypot(dx, dy);
    if (dx == 0 || dy == 0) return single(to, tool_.cutting);
    // Corners lie |dx dy| / (2 count length) beside the line; half of the tolerance is theirs.
    const double wanted = std::ceil(std::fabs(dx * dy) / (length * tool_.tolerance));
    const int count = static_cast<int>(std::clamp(wanted, 1.0, 1e6));
    const Point from = at_;
    for (int n = 0; n < count; ++n) {
      single({from.x + dx * (n + 0.5) / count, at_.y}, tool_.cutting);
      single({at_.x, from.y + dy * (n + 1.0) / count}, tool_.cutting);
    }
    single(to, tool_.cutting);
  }
  /// With the tool on the way: a lead-in, on, the chain, off and a ramp. Else from rest to rest at its full
  /// speed. A long chain is more than one of them.
  void contours(const Chain& c) {
    StepList pieces;
    for (const Curve& curve : c.curves) {
      if (curve.length() == 0) continue;
      Move line = move_to(curve.to, {});
      if (curve.kind == Curve::Kind::line)
        pieces.push_back({line});
      else
        pieces.push_back({Arc{curve.centre.x, curve.centre.y, curve.degrees, {}}});
    }
    Point begin = c.begin();
    std::size_t curve = 0;
    for (std::size_t first = 0; first < pieces.size(); first += ix_of(tool_.contour_pieces)) {
      const std::size_t end = std::min(first + ix_of(tool_.contour_pieces), pieces.size());
      Contour part;
      part.x = begin.x, part.y = begin.y;
      if (tool_.cutting != Speeds{}) part.own = tool_.cutting;
      if (on_the_way_) {
        part.lead_in = tool_.cutting.high * tool_.cutting.ramp_ms / 2000;
        part.steps = s_.pen_down;
      }
      part.ends_ramped = on_the_way_;
      part.steps.insert(part.steps.end(), pieces.begin() + static_cast<std::ptrdiff_t>(first),
                        pieces.begin() + static_cast<std::ptrdiff_t>(end));
      if (on_the_way_) part.steps.insert(part.steps.end(), s_.pen_up.begin(), s_.pen_up.end());
      for (std::size_t n = first; n < end; ++curve)
        if (c.curves[curve].length() > 0) begin = c.curves[curve].to, ++n;
      add(std::move(part));
    }
    at_ = c.end();
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
    const double rx = curve.from.x - curve.centre.x, ry = curve.from.y - curve.centre.y;
    const double radius = std::hypot(rx, ry), sweep = curve.degrees / 180 * std::numbers::pi;
    const double widest = 2 * std::acos(std::clamp(1 - tolerance / radius, -0.5, 1.0));
    const double wanted = widest > 0 ? std::ceil(std::fabs(sweep) / widest) : 1e6;
    const int count = static_cast<int>(std::clamp(wanted, 1.0, 1e6));
    for (int n = 1; n < count; ++n) {
      const double angle = std::atan2(ry, rx) + sweep * n / count;
      put({curve.centre.x + radius * std::cos(angle), curve.centre.y + radius * std::sin(angle)});
    }
  }
  put(curve.to);
}

void draw_chains(const std::vector<Chain>& chains, const Tool& tool, Sequence& sequence) {
  Draw draw(tool, sequence);
  draw.begin();
  for (const Chain& chain : chains) draw.chain(chain);
}

void draw_frame(const Box& box, const Tool& tool, Sequence& sequence) {
  Draw draw(tool, sequence);
  draw.begin();
  draw.frame(box);
}

}  // namespace hw::drawing
