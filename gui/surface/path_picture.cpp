#include "gui/surface/path_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace hw::gui {
namespace {

using drawing::PathView;
using drawing::Point;
using drawing::Point3;
using drawing::ToolPath;

/// The coverage of each pixel by lines, up to 255. Overlapping lines do not add up.
class Coverage {
 public:
  Coverage(int width, int height)
      : width_(width),
        height_(height),
        of_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0) {}
  void set_width(float width, float dash, float dash_gap) {
    half_ = width / 2, dash_ = dash, period_ = dash + dash_gap;
    nothing_ = half_ + 0.5f;
  }
  /// Adds a line with round ends and soft edges. `walked`: length of the path before it in pixels, for the
  /// dashes.
  void line(Point a, Point b, double walked);
  void line_without_dashes(Point a, Point b) {
    const float period = std::exchange(period_, 0.0f);
    line(a, b, 0);
    period_ = period;
  }
  /// The middle of the part inside the picture; nullopt: the line is outside.
  [[nodiscard]] std::optional<Point> middle(Point a, Point b) const {
    double cut = 0;
    if (!clip(a, b, cut)) return std::nullopt;
    return Point{(a.x + b.x) / 2, (a.y + b.y) / 2};
  }
  [[nodiscard]] const std::vector<std::uint8_t>& values() const { return of_; }

 private:
  /// A line relative to a pixel's centre. Single precision is enough inside the picture.
  struct Line {
    float x, y, unit_x, unit_y, length, walked;
  };
  bool clip(Point& a, Point& b, double& cut) const;
  void cover(int x, int y, const Line& line) {
    std::uint8_t& there =
        of_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    if (there == 255) return;
    const float px = static_cast<float>(x) - line.x, py = static_cast<float>(y) - line.y;
    const float on = std::clamp(px * line.unit_x + py * line.unit_y, 0.0f, line.length);
    const float off_x = px - on * line.unit_x, off_y = py - on * line.unit_y;
    const float squared = off_x * off_x + off_y * off_y;
    if (squared >= nothing_ * nothing_ || in_a_gap(line.walked + on)) return;
    const float covered = std::min(nothing_ - std::sqrt(squared), 1.0f);
    there = std::max(there, static_cast<std::uint8_t>(covered * 255 + 0.5f));
  }
  [[nodiscard]] bool in_a_gap(float way) const {
    return period_ > 0 && way - period_ * std::floor(way / period_) > dash_;
  }

  int width_, height_;
  float half_ = 0.5f, dash_ = 0, period_ = 0;
  float nothing_ = 1;  ///< no coverage at this distance of a pixel's centre from the line
  std::vector<std::uint8_t> of_;
};

/// Clips a line, which may be far longer than the picture, to the picture and a margin (Liang and Barsky).
bool Coverage::clip(Point& a, Point& b, double& cut) const {
  const double edge = half_ + 1, dx = b.x - a.x, dy = b.y - a.y;
  double enter = 0, leave = 1;
  const auto narrow = [&](double speed, double room) {
    if (speed == 0) return room >= 0;
    const double t = room / speed;
    if (speed < 0)
      enter = std::max(enter, t);
    else
      leave = std::min(leave, t);
    return true;
  };
  if (!narrow(-dx, a.x + edge) || !narrow(dx, width_ + edge - a.x) || !narrow(-dy, a.y + edge) ||
      !narrow(dy, height_ + edge - a.y) || enter > leave)
    return false;
  cut = enter > 0 ? enter * std::sqrt(dx * dx + dy * dy) : 0;
  const Point from = a;
  a = {from.x + enter * dx, from.y + enter * dy}, b = {from.x + leave * dx, from.y + leave * dy};
  return true;
}

void Coverage::line(Point a, Point b, double walked) {
  double cut = 0;
  if (!clip(a, b, cut)) return;
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
  const auto single = [](double value) { return static_cast<float>(value); };
  const Line l{single(a.x - 0.5),
               single(a.y - 0.5),
               length > 0 ? single(dx / length) : 1,
               length > 0 ? single(dy / length) : 0,
               single(length),
               period_ > 0 ? single(std::fmod(walked + cut, static_cast<double>(period_))) : 0};
  // Steps along the longer direction of the line, and across it over its width.
  const bool flat = std::fabs(dx) >= std::fabs(dy);
  const double slope = flat ? (dx == 0 ? 0 : dy / dx) : dx / dy;
  const double along = (flat ? a.x : a.y) - 0.5, side = (flat ? a.y : a.x) - 0.5;
  const double off = static_cast<double>(nothing_), reach = off * std::sqrt(1 + slope * slope);
  const auto [from, to] = std::minmax({along, (flat ? b.x : b.y) - 0.5});
  const auto [low_end, high_end] = std::minmax({side, (flat ? b.y : b.x) - 0.5});
  const int first = std::max(0, static_cast<int>(std::ceil(from - off)));
  const int last = std::min((flat ? width_ : height_) - 1, static_cast<int>(std::floor(to + off)));
  for (int i = first; i <= last; ++i) {
    const double centre = side + (i - along) * slope;
    const int low = std::max(0, static_cast<int>(std::ceil(std::max(centre - reach, low_end - off))));
    const int high = std::min((flat ? height_ : width_) - 1,
                              static_cast<int>(std::floor(std::min(centre + reach, high_end + off))));
    for (int j = low; j <= high; ++j) flat ? cover(i, j, l) : cover(j, i, l);
  }
}

/// Draws consecutive runs; skips points that fall on the same pixel.
class Stroke {
 public:
  Stroke(const PathView& view, Coverage& coverage, double arrow_every, double arrow)
      : view_(view), coverage_(coverage), arrow_every_(arrow_every), arrow_(arrow) {}
  /// `points` are those of the path. A run that begins where the previous run ended continues its stroke.
  void run(const std::vector<Point3>& points, const ToolPath::Run& run) {
    constexpr double apart = 0.35;
    if (run.first != end_) {
      lift();
      from_ = latest_ = view_.to_px(points[run.first]);
    }
    end_ = run.first + run.size - 1;
    for (std::size_t i = run.first + 1; i <= end_; ++i) {
      latest_ = view_.to_px(points[i]);
      if (std::fabs(latest_.x - from_.x) >= apart || std::fabs(latest_.y - from_.y) >= apart) lift();
    }
  }
  /// Draws the stroke so far.
  void lift() {
    if (latest_ == from_) return;
    coverage_.line(from_, latest_, walked_);
    const double dx = latest_.x - from_.x, dy = latest_.y - from_.y, length = std::sqrt(dx * dx + dy * dy);
    walked_ += length, since_arrow_ += length;
    if (arrow_every_ > 0 && since_arrow_ >= arrow_every_)
      if (const auto middle = coverage_.middle(from_, latest_))
        point_along({dx / length, dy / length}, *middle);
    from_ = latest_;
  }

 private:
  void point_along(Point unit, Point tip) {
    constexpr double back = 0.87, aside = 0.5;
    since_arrow_ = 0;
    tip = {tip.x + unit.x * arrow_ / 2, tip.y + unit.y * arrow_ / 2};
    for (const double side : {-aside, aside})
      coverage_.line_without_dashes(tip, {tip.x - arrow_ * (back * unit.x + side * unit.y),
                                          tip.y - arrow_ * (back * unit.y - side * unit.x)});
  }

  const PathView& view_;
  Coverage& coverage_;
  double arrow_every_, arrow_, since_arrow_ = 0;
  Point from_, latest_;
  double walked_ = 0;
  std::size_t end_ = std::numeric_limits<std::size_t>::max();  ///< index of `latest_`; max: none yet
};

/// Blends with straight alpha over a pixel, which may be transparent itself.
void lay_over(std::uint32_t& there, ImU32 colour, unsigned coverage) {
  const unsigned above = (colour >> IM_COL32_A_SHIFT & 255u) * coverage / 255,
                 below = there >> IM_COL32_A_SHIFT & 255u;
  if (above == 0) return;
  if (below == 0) {
    there = (colour & ~IM_COL32_A_MASK) | above << IM_COL32_A_SHIFT;
    return;
  }
  const unsigned kept = below * (255 - above) / 255, alpha = above + kept;
  std::uint32_t out = alpha << IM_COL32_A_SHIFT;
  for (const int shift : {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT})
    out |= ((colour >> shift & 255u) * above + (there >> shift & 255u) * kept) / alpha << shift;
  there = out;
}

void lay_over(Picture& picture, const Coverage& coverage, ImU32 colour) {
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    lay_over(picture.pixels[i], colour, coverage.values()[i]);
}

double arrows_apart(const ToolPath& path, const PathLook& look, const PathView& view) {
  constexpr double most = 300;
  const double all = (path.way_on + path.way_off) / std::max(view.per_px().x, view.per_px().y);
  return look.arrow_every > 0 ? std::max(static_cast<double>(look.arrow_every), all / most) : 0;
}

void lay_over(Picture& picture, const PathLayer& layer, const PathView& view) {
  const auto& all = layer.path->runs;
  const std::size_t end = std::min(layer.end_run, all.size()), first = std::min(layer.first_run, end);
  const std::span runs(all.data() + first, end - first);
  const double every = arrows_apart(*layer.path, layer.look, view);
  for (const bool tool_on : {false, true}) {
    const auto wanted = [tool_on](const ToolPath::Run& run) { return run.tool_on == tool_on; };
    if (std::none_of(runs.begin(), runs.end(), wanted)) continue;
    Coverage coverage(picture.width, picture.height);
    const PathLook& look = layer.look;
    coverage.set_width(tool_on ? look.on_width : look.off_width, tool_on ? 0 : look.dash,
                       tool_on ? 0 : look.dash_gap);
    Stroke stroke(view, coverage, every, look.arrow);
    for (const ToolPath::Run& run : runs)
      if (wanted(run)) stroke.run(layer.path->points, run);
    stroke.lift();
    lay_over(picture, coverage, tool_on ? look.tool_on : look.tool_off);
  }
}

}  // namespace

Picture path_picture(std::span<const PathLayer> layers, const PathView& view) {
  Picture picture;
  picture.width = static_cast<int>(view.width_px()), picture.height = static_cast<int>(view.height_px());
  picture.pixels.assign(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height),
                        0);
  for (const PathLayer& layer : layers) lay_over(picture, layer, view);
  return picture;
}

}  // namespace hw::gui
