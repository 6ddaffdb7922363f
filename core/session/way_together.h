#pragma once
// The way that a tool really goes along a drawing where each of its axes is a controller of its own: it is no
// straight line, as they begin one command on the wire apart and each has its own ramps.
#include "core/device/catalog.h"
#include "core/device/language.h"
#include "core/drawing/tool_path.h"
#include "core/session/conversion.h"

namespace hw {

struct WayTogether {
  drawing::ToolPath path;  ///< a source is a chain
  double beside = 0;       ///< so far it lies at most beside a straight line, with the tool on
};
/// In the unit of the sequence. `done` is of rehearse_together(), `bus` of catalog_together().
WayTogether way_together(const Conversion& made, const Rehearsal& done, const Catalog& bus);
/// How long it takes from when it has come to that step.
[[nodiscard]] double seconds_from(int step, const Rehearsal& done);

}  // namespace hw
