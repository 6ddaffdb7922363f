#pragma once
// Paths as an SVG file, in the units of their axes, each in a group of its own.
#include <span>
#include <string>
#include <string_view>

#include "core/drawing/tool_path.h"

namespace hw::drawing {

struct SvgLayer {
  std::string_view name;  ///< of its group; of what goes with the tool off "NAME-tool-off"
  const ToolPath* path = nullptr;
  std::string_view colour = "#000";
  double width_px = 1.5;
};
struct SvgWords {
  std::string_view
      unit;  ///< as people write it; where SVG knows it too (mm, in, cm), it is as large as the path
  std::string_view about;  ///< what the numbers are, for people
};
/// Later layers lie over earlier ones; one without a path is left out.
std::string path_svg(std::span<const SvgLayer> layers, const SvgWords& words);

}  // namespace hw::drawing
