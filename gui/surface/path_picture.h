#pragma once
// Draws the path of a tool into a picture. A worker does it, because a path of a million lines takes longer
// than a frame.
#include <cstddef>
#include <limits>
#include <span>

#include "core/drawing/tool_path.h"
#include "gui/surface/pictures.h"

namespace hw::gui {

struct PathLook {
  ImU32 tool_on = 0, tool_off = 0;
  float on_width = 2, off_width = 1;  ///< pixels
  float dash = 0, dash_gap = 0;       ///< lengths in pixels, for moves with the tool off; 0: no dashes
  /// Spacing along the path and length of the direction arrows, in pixels; 0: no arrows. The spacing is
  /// larger on very long paths.
  float arrow_every = 0, arrow = 0;
  bool operator==(const PathLook&) const = default;
};

struct PathLayer {
  const drawing::ToolPath* path = nullptr;
  PathLook look;
  /// Draws only these runs of the path.
  std::size_t first_run = 0, end_run = std::numeric_limits<std::size_t>::max();
};
/// Returns a picture of the view's size. Later layers cover earlier ones. Pure; any thread; may take seconds.
Picture path_picture(std::span<const PathLayer> layers, const drawing::PathView& view);

}  // namespace hw::gui
