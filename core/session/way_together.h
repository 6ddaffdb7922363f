#pragma once
// The real path of a tool whose axes are separate controllers. Its lines are not straight, as the axes begin
// one command on the wire apart and each has its own ramps.
#include "core/device/catalog.h"
#include "core/device/language.h"
#include "core/drawing/tool_path.h"
#include "core/session/conversion.h"

namespace hw {

struct WayTogether {
  drawing::ToolPath path;  ///< a source is a chain
  double beside = 0;       ///< largest distance from a straight line with the tool on
};
/// In the unit of the sequence. `done`: of rehearse_together(); `bus`: of catalog_together().
WayTogether way_together(const Conversion& made, const Rehearsal& done, const Catalog& bus);
/// Time from the arrival at `step` to the end.
[[nodiscard]] double seconds_from(int step, const Rehearsal& done);

}  // namespace hw
