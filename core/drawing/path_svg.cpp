#include "core/drawing/path_svg.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace hw::drawing {
namespace {

constexpr double picture_px = 800;

bool known_to_svg(std::string_view unit) { return unit == "mm" || unit == "cm" || unit == "in"; }

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return out;
}

/// `px`: a pixel of the picture in the path's units. Used because some programs do not support a stroke that
/// does not scale.
void write_runs(std::string& out, const SvgLayer& layer, bool tool_on, double px) {
  const ToolPath& path = *layer.path;
  const auto wanted = [tool_on](const ToolPath::Run& run) { return run.tool_on == tool_on; };
  if (std::none_of(path.runs.begin(), path.runs.end(), wanted)) return;
  const std::string dashes =
      tool_on ? "" : fmt::format(" stroke-dasharray=\"{:.4g} {:.4g}\"", 5 * px, 4 * px);
  out += fmt::format("<g id=\"{}{}\" stroke=\"{}\" stroke-width=\"{:.4g}\"{}>\n", layer.name,
                     tool_on ? "" : "-tool-off", tool_on ? layer.colour : "#888",
                     (tool_on ? layer.width_px : 1.0) * px, dashes);
  for (const ToolPath::Run& run : path.runs) {
    if (!wanted(run)) continue;
    out += "<polyline points=\"";
    for (std::size_t i = run.first; i < run.first + run.size; ++i)
      out += fmt::format("{}{},{}", i == run.first ? "" : " ", path.points[i].x, -path.points[i].y);
    out += "\"/>\n";
  }
  out += "</g>\n";
}

/// Places and directions of the arrows along a path: in the middle of its lines, at least so far apart.
struct Arrow {
  Point at, unit;
};
std::vector<Arrow> arrows_along(const ToolPath& path, double apart) {
  std::vector<Arrow> arrows;
  double since = apart / 2;  // a short path has an arrow too
  for (const ToolPath::Run& run : path.runs)
    for (std::size_t i = run.first + 1; i < run.first + run.size; ++i) {
      const Point3 &from = path.points[i - 1], &to = path.points[i];
      const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
      since += length;
      if (since < apart || length == 0) continue;
      since = 0;
      arrows.push_back({{(from.x + to.x) / 2, (from.y + to.y) / 2}, {dx / length, dy / length}});
    }
  return arrows;
}

void write_arrows(std::string& out, const SvgLayer& layer, double size, double px) {
  constexpr double apart = 9, most = 300, back = 0.87, aside = 0.5;  // in arrows
  const ToolPath& path = *layer.path;
  const auto arrows = arrows_along(path, std::max(apart * size, (path.way_on + path.way_off) / most));
  if (arrows.empty()) return;
  out += fmt::format("<g id=\"{}-direction\" stroke=\"{}\" stroke-width=\"{:.4g}\">\n", layer.name,
                     layer.colour, layer.width_px * px);
  for (const Arrow& a : arrows) {
    const Point tip{a.at.x + a.unit.x * size / 2, a.at.y + a.unit.y * size / 2};
    const auto end = [&](double side) {
      return Point{tip.x - size * (back * a.unit.x + side * a.unit.y),
                   tip.y - size * (back * a.unit.y - side * a.unit.x)};
    };
    const Point left = end(-aside), right = end(aside);
    out += fmt::format("<polyline points=\"{:.6g},{:.6g} {:.6g},{:.6g} {:.6g},{:.6g}\"/>\n", left.x, -left.y,
                       tip.x, -tip.y, right.x, -right.y);
  }
  out += "</g>\n";
}

/// 1, 2 or 5 times a power of ten, at most `most`.
double round_length(double most) {
  const double ten = std::pow(10, std::floor(std::log10(most)));
  return most >= 5 * ten ? 5 * ten : most >= 2 * ten ? 2 * ten : ten;
}

/// The text below the paths: a bar of a round length, and the axes.
struct Legend {
  Legend(double left, double top, double wide, double longest, const SvgWords& given)
      : x(left), y(top), width(wide), words(given) {
    constexpr double lines = 45, of_a_letter = 0.62, room = 3;  // in the height of a letter
    const auto letters = static_cast<double>(std::max<std::size_t>(given.about.size(), 16));
    letter = std::min(longest / lines, wide / (of_a_letter * letters));
    height = given.about.empty() && given.unit.empty() ? 0 : room * letter;
  }
  void write(std::string& out, double px) const {
    if (height == 0) return;
    constexpr std::string_view text =
        "<text x=\"{:.6g}\" y=\"{:.6g}\" font-size=\"{:.6g}\" font-family=\"sans-serif\">{}</text>\n";
    out += fmt::format("<g id=\"scale\" stroke=\"#000\" stroke-width=\"{:.4g}\">\n", px);
    const double bar = round_length(width / 5), high = y + letter * 0.8;
    if (!words.unit.empty())
      out += fmt::format("<polyline points=\"{:.6g},{:.6g} {:.6g},{:.6g}\"/>\n", x, high, x + bar, high);
    out += "<g fill=\"#000\" stroke=\"none\">\n";
    if (!words.unit.empty())
      out += fmt::format(text, x + bar + letter / 2, high + letter / 3, letter,
                         fmt::format("{:g} {}", bar, escaped(words.unit)));
    if (!words.about.empty()) out += fmt::format(text, x, y + letter * 2.5, letter, escaped(words.about));
    out += "</g>\n</g>\n";
  }
  double x, y, width, letter = 0, height = 0;
  const SvgWords& words;
};

}  // namespace

std::string path_svg(std::span<const SvgLayer> layers, const SvgWords& words) {
  Box3 box;
  for (const SvgLayer& layer : layers)
    if (layer.path) box.add(layer.path->bounds);
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  const double longest = std::max({width, height, 1e-6}), air = longest * 0.02, w = width + 2 * air;
  const Legend foot(box.low.x, -box.low.y + air, std::max(width, longest / 4), longest, words);
  const double h = height + 2 * air + foot.height;
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  if (known_to_svg(words.unit))
    out += fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}{}\" height=\"{}{}\"", w,
                       words.unit, h, words.unit);
  else
    out += fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\"", picture_px);
  // y points up on the table and down in SVG.
  out += fmt::format(" viewBox=\"{} {} {} {}\" fill=\"none\" stroke-linejoin=\"round\">\n", box.low.x - air,
                     -box.high.y - air, w, h);
  if (!words.about.empty()) out += fmt::format("<desc>{}</desc>\n", escaped(words.about));
  const double px = w / picture_px;
  for (const SvgLayer& layer : layers) {
    if (!layer.path) continue;
    write_runs(out, layer, false, px);
    write_runs(out, layer, true, px);
    if (layer.directed) write_arrows(out, layer, longest / 90, px);
  }
  foot.write(out, px);
  return out += "</svg>\n";
}

}  // namespace hw::drawing
