#pragma once
// The path of a contour for display: arcs as many short lines.
#include "core/drawing/tool_path.h"
#include "core/sequence/sequence.h"

namespace hw::drawing {

/// `scale`: units of the view per unit of the contour, for each axis of its plane, to the right and up. The
/// tool is on while an output is, or always if none is ever switched on. The lead-in is off and has no
/// source; all else has the index of its step. Steps without length or sense are skipped: the writer reports
/// them.
ToolPath contour_path(const sequence::Contour& contour, Point scale);

}  // namespace hw::drawing
