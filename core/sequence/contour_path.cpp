#include "core/sequence/contour_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

namespace hw::sequence {
namespace {

constexpr double degrees_a_point = 3;
constexpr int most_points = 1200;  // of an arc

class Drawing {
 public:
  explicit Drawing(const Contour& contour) : contour_(contour) { put({contour.x, contour.y}); }

  ContourPath run() {
    for (std::size_t i = 0; i < contour_.steps.size(); ++i)
      if (!contour_.steps[i].skipped) draw(i);
    const double lead = direction_ ? contour_.lead_in : 0;
    const PathPoint way = direction_.value_or(PathPoint());
    path_.park = {contour_.x - way.x * lead, contour_.y - way.y * lead};
    return std::move(path_);
  }

 private:
  void draw(std::size_t i) {
    const Step& step = contour_.steps[i];
    const std::size_t before = path_.points.size() - 1;
    if (const auto* move = std::get_if<Move>(&step.body)) line(*move);
    if (const auto* arc = std::get_if<Arc>(&step.body)) round(*arc);
    if (const auto* output = std::get_if<Output>(&step.body)) {
      if (output->on)
        on_.insert(output->output);
      else
        on_.erase(output->output);
    }
    const std::size_t size = path_.points.size() - before;
    if (size > 1) path_.legs.push_back({before, size, i, static_cast<int>(on_.size())});
  }
  void line(const Move& m) {
    const PathPoint to{m.to[0].value_or(here_.x), m.to[1].value_or(here_.y)};
    const double way = std::hypot(to.x - here_.x, to.y - here_.y);
    if (way == 0) return;
    set_off({(to.x - here_.x) / way, (to.y - here_.y) / way});
    path_.length += way;
    put(to);
  }
  void round(const Arc& a) {
    const double rx = here_.x - a.x, ry = here_.y - a.y, radius = std::hypot(rx, ry);
    if (radius == 0 || a.degrees == 0) return;
    const double sense = a.degrees > 0 ? 1 : -1;
    set_off({-sense * ry / radius, sense * rx / radius});
    const double from = std::atan2(ry, rx), angle = a.degrees / 180 * std::numbers::pi;
    const double wanted = std::fabs(a.degrees) / degrees_a_point + 1;
    const int points = static_cast<int>(std::clamp(wanted, 2.0, static_cast<double>(most_points)));
    for (int n = 1; n <= points; ++n) {
      const double at = from + angle * n / points;
      put({a.x + radius * std::cos(at), a.y + radius * std::sin(at)});
    }
    path_.length += radius * std::fabs(angle);
  }
  void set_off(PathPoint direction) {
    if (!direction_) direction_ = direction;
  }
  void put(PathPoint p) {
    path_.points.push_back(p);
    here_ = p;
  }

  const Contour& contour_;
  ContourPath path_;
  PathPoint here_;
  std::optional<PathPoint> direction_;
  std::set<int> on_;
};

}  // namespace

ContourPath contour_path(const Contour& contour) { return Drawing(contour).run(); }

}  // namespace hw::sequence
