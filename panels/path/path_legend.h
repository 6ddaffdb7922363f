#pragma once
// Draws the meaning of a path's lines, and the totals of the path. Ids: `path/size`, `path/way_on`,
// `path/way_off`, `path/time`, `path/refusal`, `path/thinned`, `path/legend/trace`.
#include "panels/path/program_path.h"

namespace hw::panels {

/// Draws at ImGui's cursor, down to `height`.
void draw_path_legend(gui::Frame& frame, float height, const ProgramPath& program,
                      const PathSubject& subject);

}  // namespace hw::panels
