#include "core/drawing/contour_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/base/index.h"
#include "core/sequence/arc_shape.h"

namespace hw::drawing {
namespace {

using sequence::Arc;
using sequence::Move;
using sequence::Output;

constexpr double degrees_a_point = 1;
constexpr int most_points = 1200;  // of an arc

bool switches_on(const sequence::Step& step) {
  const auto* output = std::get_if<Output>(&step.body);
  return output && output->on && !step.skipped;
}

class DrawnContour {
 public:
  DrawnContour(const sequence::Contour& contour, Point scale)
      : contour_(contour),
        scale_(scale),
        always_on_(std::none_of(contour.steps.begin(), contour.steps.end(), switches_on)) {}

  ToolPath run() {
    const auto way = sequence::sets_off(contour_);
    here_ = {contour_.x, contour_.y};
    if (way && contour_.lead_in > 0) {
      const Point park{here_.x - way->first * contour_.lead_in, here_.y - way->second * contour_.lead_in};
      path_.go(scaled(park), scaled(here_), false, -1);
    }
    for (std::size_t i = 0; i < contour_.steps.size(); ++i)
      if (!contour_.steps[i].skipped) draw(contour_.steps[i], static_cast<int>(i));
    return std::move(path_);
  }

 private:
  [[nodiscard]] Point scaled(Point p) const { return {p.x * scale_.x, p.y * scale_.y}; }
  void draw(const sequence::Step& step, int place) {
    if (const auto* move = std::get_if<Move>(&step.body)) go(end_of(*move), place);
    if (const auto* arc = std::get_if<Arc>(&step.body)) round(*arc, place);
    if (const auto* output = std::get_if<Output>(&step.body)) {
      if (output->on)
        on_.insert(output->output);
      else
        on_.erase(output->output);
    }
  }
  [[nodiscard]] Point end_of(const Move& m) const {
    const auto [right, up] = contour_.plane;
    return {m.to[ix(right)].value_or(here_.x), m.to[ix(up)].value_or(here_.y)};
  }
  void round(const Arc& a, int place) {
    const double rx = here_.x - a.x, ry = here_.y - a.y, radius = std::hypot(rx, ry);
    if (radius == 0 || a.degrees == 0) return;
    const double from = std::atan2(ry, rx), angle = a.degrees / 180 * std::numbers::pi;
    const double wanted = std::fabs(a.degrees) / degrees_a_point + 1;
    const int points = static_cast<int>(std::clamp(wanted, 2.0, static_cast<double>(most_points)));
    for (int n = 1; n <= points; ++n) {
      const double at = from + angle * n / points;
      go({a.x + radius * std::cos(at), a.y + radius * std::sin(at)}, place);
    }
  }
  void go(Point to, int place) {
    if (to == here_) return;
    path_.go(scaled(here_), scaled(to), always_on_ || !on_.empty(), place);
    here_ = to;
  }

  const sequence::Contour& contour_;
  const Point scale_;
  const bool always_on_;
  ToolPath path_;
  Point here_;
  std::set<int> on_;
};

}  // namespace

ToolPath contour_path(const sequence::Contour& contour, Point scale) {
  return DrawnContour(contour, scale).run();
}

}  // namespace hw::drawing
