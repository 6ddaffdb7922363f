#pragma once
// Paths as an SVG file, in the units of their axes, each in a group of its own.
#include <span>
#include <string>
#include <string_view>

#include "core/drawing/tool_path.h"

namespace hw::drawing {

struct SvgLayer {
  std::string_view name;  ///< of its group; with the tool off: "NAME-tool-off"
  const ToolPath* path = nullptr;
  std::string_view colour = "#000";
  double width_px = 1.5;
  bool directed = false;  ///< has arrows that show its direction, in the group "NAME-direction"
};
struct SvgWords {
  /// As people write it. If SVG knows the unit (mm, in, cm), the image is true to size. If it is not empty,
  /// the image has a scale.
  std::string_view unit;
  std::string_view about;  ///< meaning of the numbers, for people; below the paths
};
/// Later layers cover earlier ones; a layer without a path is omitted. The group "scale" is below all of
/// them.
std::string path_svg(std::span<const SvgLayer> layers, const SvgWords& words);

}  // namespace hw::drawing
