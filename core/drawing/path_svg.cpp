#include "core/drawing/path_svg.h"

#include <algorithm>

#include <fmt/format.h>

namespace hw::drawing {
namespace {

bool known_to_svg(std::string_view unit) { return unit == "mm" || unit == "cm" || unit == "in"; }

}  // namespace

std::string path_svg(const ToolPath& path, std::string_view unit) {
  const Box3& box = path.bounds;
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  const double air = std::max({width, height, 1e-6}) * 0.02;
  const double w = width + 2 * air, h = height + 2 * air;
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  if (known_to_svg(unit))
    out += fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}{}\" height=\"{}{}\"", w, unit, h,
                       unit);
  else
    out += "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\"";
  // y goes upwards on the table and downwards in SVG.
  out += fmt::format(" viewBox=\"{} {} {} {}\">\n", box.low.x - air, -box.high.y - air, w, h);
  out +=
      "<style>polyline { fill: none; stroke: #000; stroke-width: 1.5px; vector-effect: non-scaling-stroke; "
      "stroke-linejoin: round } .off { stroke: #888; stroke-width: 1px; stroke-dasharray: 5 4 }</style>\n";
  for (const ToolPath::Run& run : path.runs) {
    out += run.tool_on ? "<polyline class=\"on\" points=\"" : "<polyline class=\"off\" points=\"";
    for (std::size_t i = run.first; i < run.first + run.size; ++i)
      out += fmt::format("{}{},{}", i == run.first ? "" : " ", path.points[i].x, -path.points[i].y);
    out += "\"/>\n";
  }
  return out += "</svg>\n";
}

}  // namespace hw::drawing
