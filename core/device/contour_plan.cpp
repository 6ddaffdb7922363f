#include "core/device/contour_plan.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace hw {
namespace {

constexpr double degrees_a_point = 3;

tl::unexpected<Fault> piece_fault(std::size_t piece, std::string_view why) {
  return fail(FaultKind::text, fmt::format("Piece {}: {}", piece + 1, why), "Nothing was sent.");
}

bool in_range(const Catalog& c, Steps s) { return s >= c.position_min && s <= c.position_max; }

class Drawing {
 public:
  Drawing(const ContourPlan& plan, const Catalog& catalog) : plan_(plan), catalog_(catalog) {}

  Result<ContourShape> run() {
    put({static_cast<double>(plan_.x.value), static_cast<double>(plan_.y.value)});
    for (std::size_t i = 0; i < plan_.pieces.size(); ++i) {
      auto drawn = draw(i);
      if (!drawn) return fail(drawn.error());
    }
    if (shape_.legs.empty())
      return fail(FaultKind::text, "The contour has no line and no arc.", "Nothing was sent.", "Add one.");
    const ContourPoint a = shape_.points[0], b = shape_.points[1];
    const double run = std::hypot(b.x - a.x, b.y - a.y), lead = static_cast<double>(plan_.lead_in.value);
    shape_.park = {a.x - direction_.x * lead, a.y - direction_.y * lead};
    if (run <= 0) shape_.park = a;
    return std::move(shape_);
  }

 private:
  Result<> draw(std::size_t i) {
    const ContourPiece& p = plan_.pieces[i];
    if (p.kind == ContourPiece::Kind::output) return switch_output(i);
    if (!in_range(catalog_, p.x) || !in_range(catalog_, p.y))
      return piece_fault(i, fmt::format("positions go from {} to {}.", catalog_.position_min.value,
                                        catalog_.position_max.value));
    const std::size_t before = shape_.points.size() - 1;
    if (auto done = p.kind == ContourPiece::Kind::line ? line(i) : arc(i); !done) return done;
    shape_.legs.push_back({before, shape_.points.size() - before, i, static_cast<int>(on_.count())});
    return {};
  }
  Result<> switch_output(std::size_t i) {
    const ContourPiece& p = plan_.pieces[i];
    if (p.output < 0 || static_cast<std::size_t>(p.output) >= catalog_.outputs.size())
      return piece_fault(i, "there is no such output.");
    on_[static_cast<std::size_t>(p.output)] = p.on;
    return {};
  }
  Result<> line(std::size_t i) {
    const ContourPoint to{static_cast<double>(plan_.pieces[i].x.value),
                          static_cast<double>(plan_.pieces[i].y.value)};
    const double way = std::hypot(to.x - here_.x, to.y - here_.y);
    if (way == 0) return piece_fault(i, "the line ends where it begins.");
    begin_towards({(to.x - here_.x) / way, (to.y - here_.y) / way});
    shape_.length += way;
    put(to);
    return {};
  }
  Result<> arc(std::size_t i) {
    const ContourPiece& p = plan_.pieces[i];
    const ContourPoint centre{static_cast<double>(p.x.value), static_cast<double>(p.y.value)};
    const double rx = here_.x - centre.x, ry = here_.y - centre.y, radius = std::hypot(rx, ry);
    if (radius == 0) return piece_fault(i, "the centre of the arc is the point where it begins.");
    if (p.degrees == 0) return piece_fault(i, "the arc goes round by 0 degrees.");
    const double sense = p.degrees > 0 ? 1 : -1;
    begin_towards({-sense * ry / radius, sense * rx / radius});
    const double from = std::atan2(ry, rx), angle = p.degrees / 180 * std::numbers::pi;
    const int points = std::clamp(static_cast<int>(std::fabs(p.degrees) / degrees_a_point) + 1, 2, 1200);
    for (int n = 1; n <= points; ++n) {
      const double at = from + angle * n / points;
      put({centre.x + radius * std::cos(at), centre.y + radius * std::sin(at)});
    }
    shape_.length += radius * std::fabs(angle);
    return {};
  }
  void begin_towards(ContourPoint direction) {
    if (shape_.legs.empty()) direction_ = direction;
  }
  void put(ContourPoint p) {
    shape_.points.push_back(p);
    here_ = p;
  }

  const ContourPlan& plan_;
  const Catalog& catalog_;
  ContourShape shape_;
  ContourPoint here_, direction_;
  std::bitset<64> on_;
};

}  // namespace

Result<ContourShape> draw_contour(const ContourPlan& plan, const Catalog& c) {
  if (plan.first == plan.second)
    return fail(FaultKind::text, "A contour needs two different axes.", "Nothing was sent.");
  if (plan.speed.value < 1 || plan.speed > c.jog_speed_max)
    return fail(FaultKind::text,
                fmt::format("The speed goes from 1 to {} {}/s.", c.jog_speed_max.value, c.step_word),
                "Nothing was sent.");
  if (!in_range(c, plan.x) || !in_range(c, plan.y))
    return fail(
        FaultKind::text,
        fmt::format("The begin lies outside of {} to {}.", c.position_min.value, c.position_max.value),
        "Nothing was sent.");
  return Drawing(plan, c).run();
}

Result<> check_staircase(const StaircasePlan& plan, const Catalog& c) {
  const auto wrong = [](std::string why) {
    return fail(FaultKind::text, std::move(why), "Nothing was sent.");
  };
  if (plan.steps.empty()) return wrong("The staircase has no step.");
  if (plan.stop_at == plan.from) return wrong("It stops where the axis stands.");
  const bool up = plan.stop_at > plan.from;
  Steps before = plan.from;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const StaircaseStep& s = plan.steps[i];
    if (s.speed.value < 1 || s.speed > c.jog_speed_max)
      return wrong(fmt::format("Step {}: the speed goes from 1 to {} {}/s.", i + 1, c.jog_speed_max.value,
                               c.step_word));
    if (s.until == before || (s.until > before) != up)
      return wrong(fmt::format("Step {}: {} does not lie on the way from {} to {}.", i + 1, s.until.value,
                               before.value, plan.stop_at.value));
    before = s.until;
  }
  if (!in_range(c, plan.stop_at))
    return wrong(fmt::format("Positions go from {} to {}.", c.position_min.value, c.position_max.value));
  if ((plan.stop_at > before) != up || plan.stop_at == before)
    return wrong(
        fmt::format("It has passed {} when the last step ends at {}.", plan.stop_at.value, before.value));
  return {};
}

}  // namespace hw
