#pragma once
// Draws time charts of outputs and inputs. Ids: `rehearsal/io/1`, `rehearsal/io/2`, in their order.
#include <optional>
#include <vector>

#include "gui/surface/ui.h"
#include "panels/program/io_lanes.h"

namespace hw::panels {

/// Draws at ImGui's cursor, over the remaining width. `now_s`: progress of the run; nullopt: no run.
void draw_io_chart(gui::Ui& ui, const std::vector<IoLane>& lanes, double duration_s,
                   std::optional<double> now_s);

}  // namespace hw::panels
