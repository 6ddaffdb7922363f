#pragma once
// Reads DXF files with dxflib. Nothing is dropped silently: everything but lines, arcs, circles, points,
// polylines, ellipses, splines and inserts of these in the plane of the drawing is listed in
// Drawing::left_out, with its place in the file.
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/drawing/drawing.h"
#include "core/drawing/shape.h"

namespace hw::drawing {

/// Long: for a worker. The fault names the file and, if known, the line.
Result<Drawing> read_dxf(std::string_view text, const std::string& name, const Tolerance& tolerance);

}  // namespace hw::drawing
