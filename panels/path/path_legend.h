#pragma once
// What the lines of a path mean, and what the path comes to. Ids: `path/size`, `path/way_on`, `path/way_off`,
// `path/time`, `path/thinned`, `path/legend/trace`.
#include "panels/path/program_path.h"

namespace hw::panels {

/// At ImGui's cursor, down to `height`.
void draw_path_legend(gui::Frame& frame, float height, const ProgramPath& program,
                      const PathSubject& subject);

}  // namespace hw::panels
