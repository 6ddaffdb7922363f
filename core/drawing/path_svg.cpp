#include "core/drawing/path_svg.h"

#include <algorithm>

#include <fmt/format.h>

namespace hw::drawing {
namespace {

bool known_to_svg(std::string_view unit) { return unit == "mm" || unit == "cm" || unit == "in"; }

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return out;
}

void write_runs(std::string& out, const SvgLayer& layer, bool tool_on) {
  const ToolPath& path = *layer.path;
  const auto wanted = [tool_on](const ToolPath::Run& run) { return run.tool_on == tool_on; };
  if (std::none_of(path.runs.begin(), path.runs.end(), wanted)) return;
  out += fmt::format("<g id=\"{}{}\" stroke=\"{}\" stroke-width=\"{}\"{}>\n", layer.name,
                     tool_on ? "" : "-tool-off", tool_on ? layer.colour : "#888",
                     tool_on ? layer.width_px : 1.0, tool_on ? "" : " stroke-dasharray=\"5 4\"");
  for (const ToolPath::Run& run : path.runs) {
    if (!wanted(run)) continue;
    out += "<polyline points=\"";
    for (std::size_t i = run.first; i < run.first + run.size; ++i)
      out += fmt::format("{}{},{}", i == run.first ? "" : " ", path.points[i].x, -path.points[i].y);
    out += "\"/>\n";
  }
  out += "</g>\n";
}

}  // namespace

std::string path_svg(std::span<const SvgLayer> layers, const SvgWords& words) {
  Box3 box;
  for (const SvgLayer& layer : layers)
    if (layer.path) box.add(layer.path->bounds);
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  const double air = std::max({width, height, 1e-6}) * 0.02;
  const double w = width + 2 * air, h = height + 2 * air;
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  if (known_to_svg(words.unit))
    out += fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}{}\" height=\"{}{}\"", w,
                       words.unit, h, words.unit);
  else
    out += "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\"";
  // y points up on the table and down in SVG.
  out += fmt::format(" viewBox=\"{} {} {} {}\" fill=\"none\" stroke-linejoin=\"round\">\n", box.low.x - air,
                     -box.high.y - air, w, h);
  if (!words.about.empty()) out += fmt::format("<desc>{}</desc>\n", escaped(words.about));
  out += "<style>polyline { vector-effect: non-scaling-stroke }</style>\n";
  for (const SvgLayer& layer : layers) {
    if (!layer.path) continue;
    write_runs(out, layer, false);
    write_runs(out, layer, true);
  }
  return out += "</svg>\n";
}

}  // namespace hw::drawing
