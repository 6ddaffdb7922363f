#include "panels/path/path_progress.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hw::panels {

using drawing::Point;
using drawing::Point3;

void PathProgress::follow(const PathSubject& s) {
  Key of{s.path, s.lit, s.lit_count, s.lit_pass, s.at_work};
  if (of == of_) return;
  of_ = std::move(of);
  lit_.clear();
  reached_ = searched_ = 0;
  if (!of_.path || of_.source < 0) return;
  const std::vector<drawing::ToolPath::Run>& runs = of_.path->runs;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const int beyond = runs[r].source - of_.source;
    if (beyond < 0 || beyond >= of_.count || (of_.pass && runs[r].pass != *of_.pass)) continue;
    if (!lit_.empty() && lit_.back().end == r)
      ++lit_.back().end;
    else
      lit_.push_back({r, r + 1});
  }
}

namespace {

/// The point of a line nearest to `to`: its share of the line, and its distance.
std::pair<double, double> nearest_on(Point from, Point end, Point to) {
  const double dx = end.x - from.x, dy = end.y - from.y, squared = dx * dx + dy * dy;
  const double along = squared > 0 ? ((to.x - from.x) * dx + (to.y - from.y) * dy) / squared : 1;
  const double share = std::clamp(along, 0.0, 1.0);
  return {share, std::hypot(from.x + share * dx - to.x, from.y + share * dy - to.y)};
}

}  // namespace

/// Where the path crosses itself, the earlier line counts until the tool has left it behind. If the tool is
/// near no line ahead, the lines behind are searched from the next frame on, because the path may have begun
/// anew.
std::optional<PathProgress::Reached> PathProgress::reached(const drawing::PathView& view, Point3 here,
                                                           double within_px) {
  constexpr std::size_t most_points = 4000;  // later frames continue the search
  if (!done()) return std::nullopt;
  const drawing::ToolPath::Run &front = of_.path->runs[lit_.front().first],
                               &back = of_.path->runs[lit_.front().end - 1];
  const std::size_t begin = front.first, end = back.first + back.size;
  const auto behind = [&](std::size_t from) { return std::min(end, from + most_points); };
  const std::size_t ahead = std::clamp(reached_, begin, end - 1);
  searched_ = std::clamp(searched_, begin, end - 1);
  const Tool tool{view, view.to_px(here), within_px};
  auto found = first_near(tool, ahead, behind(ahead));
  if (!found && searched_ != ahead) found = first_near(tool, searched_, behind(searched_));
  if (found) {
    reached_ = searched_ = found->next_point - 1;
    return found;
  }
  searched_ = behind(searched_) < end ? behind(searched_) - 1 : begin;
  return std::nullopt;
}

/// The first of the lines between two points of the path that are about as near to the tool as the nearest
/// line.
std::optional<PathProgress::Reached> PathProgress::first_near(const Tool& tool, std::size_t from,
                                                              std::size_t end) const {
  constexpr double alike_px = 2;
  const std::vector<Point3>& points = of_.path->points;
  const auto off = [&](std::size_t i) {
    return nearest_on(tool.view.to_px(points[i - 1]), tool.view.to_px(points[i]), tool.at);
  };
  double least = tool.within_px;
  for (std::size_t i = from + 1; i < end; ++i) least = std::min(least, off(i).second);
  for (std::size_t i = from + 1; i < end; ++i) {
    const auto [share, apart] = off(i);
    if (apart >= tool.within_px || apart > least + alike_px) continue;
    return Reached{points[i - 1] + (points[i] - points[i - 1]) * share, i};
  }
  return std::nullopt;
}

}  // namespace hw::panels
