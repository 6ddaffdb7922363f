#include "gui/path_picture.h"

#include <algorithm>
#include <cmath>

namespace hw::gui {
namespace {

using drawing::PathView;
using drawing::Point;
using drawing::ToolPath;

/// How much of each pixel lines cover, of 255: what lies over itself covers no more than once.
class Coverage {
 public:
  Coverage(int width, int height)
      : width_(width),
        height_(height),
        of_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0) {}
  void set_pen(float width, float dash, float dash_gap) {
    half_ = width / 2, dash_ = dash, period_ = dash + dash_gap;
  }
  /// Round ends, soft edges. `walked`: how far its dashes have come before it, pixels.
  void line(Point a, Point b, double walked);
  [[nodiscard]] const std::vector<std::uint8_t>& values() const { return of_; }

 private:
  struct Line {
    Point a, unit;
    double length;
  };
  bool clip(Point& a, Point& b, double& cut) const;
  void cover(int x, int y, const Line& line, double walked);

  int width_, height_;
  float half_ = 0.5f, dash_ = 0, period_ = 0;
  std::vector<std::uint8_t> of_;
};

/// To the picture and a little around it (Liang and Barsky): what is near may be far longer than it.
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
  cut = enter * std::hypot(dx, dy);
  const Point from = a;
  a = {from.x + enter * dx, from.y + enter * dy}, b = {from.x + leave * dx, from.y + leave * dy};
  return true;
}

void Coverage::cover(int x, int y, const Line& l, double walked) {
  const double px = x + 0.5 - l.a.x, py = y + 0.5 - l.a.y;
  const double along = px * l.unit.x + py * l.unit.y, on = std::clamp(along, 0.0, l.length);
  const double distance = std::hypot(px - on * l.unit.x, py - on * l.unit.y);
  const double covered = half_ + 0.5 - distance;
  if (covered <= 0) return;
  if (period_ > 0 && std::fmod(walked + on, period_) > dash_) return;
  const auto value = static_cast<std::uint8_t>(std::min(covered, 1.0) * 255 + 0.5);
  std::uint8_t& there =
      of_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  there = std::max(there, value);
}

void Coverage::line(Point a, Point b, double walked) {
  double cut = 0;
  if (!clip(a, b, cut)) return;
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  const Line l{a, length > 0 ? Point{dx / length, dy / length} : Point{1, 0}, length};
  // Along the longer of its two directions, and at each step across as far as the line is wide there.
  const bool flat = std::fabs(dx) >= std::fabs(dy);
  const double slope = flat ? (dx == 0 ? 0 : dy / dx) : dx / dy;
  const double reach = (half_ + 1) * std::sqrt(1 + slope * slope);
  const double from = flat ? std::min(a.x, b.x) : std::min(a.y, b.y),
               to = flat ? std::max(a.x, b.x) : std::max(a.y, b.y);
  const int steps = flat ? width_ : height_, across = flat ? height_ : width_;
  const int first = std::max(0, static_cast<int>(std::floor(from - half_ - 1)));
  const int last = std::min(steps - 1, static_cast<int>(std::ceil(to + half_ + 1)));
  for (int i = first; i <= last; ++i) {
    const double centre = (flat ? a.y : a.x) + (i + 0.5 - (flat ? a.x : a.y)) * slope;
    const int low = std::max(0, static_cast<int>(std::floor(centre - reach)));
    const int high = std::min(across - 1, static_cast<int>(std::ceil(centre + reach)));
    for (int j = low; j <= high; ++j) flat ? cover(i, j, l, walked + cut) : cover(j, i, l, walked + cut);
  }
}

/// The runs with the tool on, or those with it off. Points that no pixel tells apart are passed over.
void draw_runs(const ToolPath& path, const PathView& view, bool tool_on, Coverage& coverage) {
  constexpr double apart = 0.35;
  double walked = 0;
  for (const ToolPath::Run& run : path.runs) {
    if (run.tool_on != tool_on) continue;
    Point from = view.to_px(path.points[run.first]);
    const std::size_t last = run.first + run.size - 1;
    for (std::size_t i = run.first + 1; i <= last; ++i) {
      const Point to = view.to_px(path.points[i]);
      const double dx = std::fabs(to.x - from.x), dy = std::fabs(to.y - from.y);
      if (dx < apart && dy < apart && i != last) continue;
      coverage.line(from, to, walked);
      walked += std::hypot(dx, dy);
      from = to;
    }
  }
}

/// Straight alpha over what is there, which may let the ground through too.
void lay_over(std::uint32_t& there, ImU32 colour, unsigned coverage) {
  const unsigned above = (colour >> IM_COL32_A_SHIFT & 255u) * coverage / 255,
                 below = there >> IM_COL32_A_SHIFT & 255u;
  if (above == 0) return;
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

}  // namespace

Picture path_picture(std::span<const PathLayer> layers, const PathView& view) {
  Picture picture;
  picture.width = static_cast<int>(view.width_px()), picture.height = static_cast<int>(view.height_px());
  // What lets the ground through has a colour all the same: where pixels are mixed it must not darken a line.
  const ImU32 clear = layers.empty() ? 0 : layers.front().look.tool_on & ~IM_COL32_A_MASK;
  picture.pixels.assign(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height),
                        clear);
  for (const PathLayer& layer : layers)
    for (const bool tool_on : {false, true}) {
      Coverage coverage(picture.width, picture.height);
      if (tool_on)
        coverage.set_pen(layer.look.on_width, 0, 0);
      else
        coverage.set_pen(layer.look.off_width, layer.look.dash, layer.look.dash_gap);
      draw_runs(*layer.path, view, tool_on, coverage);
      lay_over(picture, coverage, tool_on ? layer.look.tool_on : layer.look.tool_off);
    }
  return picture;
}

}  // namespace hw::gui
