#pragma once
// The path of a tool as an SVG file, in the units of its axes.
#include <string>
#include <string_view>

#include "core/drawing/tool_path.h"

namespace hw::drawing {

/// `unit`: as people write it; where SVG knows it too (mm, in, cm), the picture is as large as the path.
std::string path_svg(const ToolPath& path, std::string_view unit);

}  // namespace hw::drawing
