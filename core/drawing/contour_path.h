#pragma once
// The path of a contour, to be looked at: arcs as many short lines.
#include "core/drawing/tool_path.h"
#include "core/sequence/sequence.h"

namespace hw::drawing {

/// `scale`: units of the view in one of the contour's, of each axis of its plane, to the right and up. The
/// tool is on while an output is, or always where none ever is; the lead-in is off and has no source, all
/// else the place of its step. What has no length or makes no sense is passed over: whoever writes it tells
/// why.
ToolPath contour_path(const sequence::Contour& contour, Point scale);

}  // namespace hw::drawing
