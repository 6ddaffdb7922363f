#pragma once
// DXF files as drawings, read with dxflib. Nothing is dropped without a word: what is not lines, arcs,
// circles, points, polylines, ellipses, splines or inserts of those in the plane of the drawing stands in
// Drawing::left_out, with its place in the file.
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/drawing/drawing.h"
#include "core/drawing/shape.h"

namespace hw::drawing {

/// Long, for a worker. The fault names the file, and the line where there is one.
Result<Drawing> read_dxf(std::string_view text, const std::string& name, const Tolerance& tolerance);

}  // namespace hw::drawing
