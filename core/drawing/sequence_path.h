#pragma once
// The way that a sequence says its tool goes, before any controller has it.
#include "core/drawing/tool_path.h"
#include "core/sequence/sequence.h"

namespace hw::drawing {

/// In its first two axes, from 0, 0. `scale`: units of the view in one of the sequence's, of both axes. A
/// source is a place in the list; what is in a loop is gone through once, with the place of the loop.
ToolPath sequence_path(const sequence::Sequence& sequence, Point scale);

}  // namespace hw::drawing
