#pragma once
// Draws a tool's path into a picture, for a worker: a path of a million lines takes too long for a frame.
#include <cstddef>
#include <limits>
#include <span>

#include "core/drawing/tool_path.h"
#include "gui/surface/pictures.h"

namespace hw::gui {

struct PathLook {
  ImU32 tool_on = 0, tool_off = 0;
  float on_width = 2, off_width = 1;  ///< pixels
  float dash = 0, dash_gap = 0;       ///< of moves with the tool off; 0: no dashes
  /// Of the direction signs, in pixels: their spacing along the path, which is larger on very long paths, and
  /// their length. 0: none.
  float arrow_every = 0, arrow = 0;
  bool operator==(const PathLook&) const = default;
};

struct PathLayer {
  const drawing::ToolPath* path = nullptr;
  PathLook look;
  /// Only these runs of the path.
  std::size_t first_run = 0, end_run = std::numeric_limits<std::size_t>::max();
};
/// The picture has the size of the view; later layers cover earlier ones. Pure and possibly slow.
Picture path_picture(std::span<const PathLayer> layers, const drawing::PathView& view);

}  // namespace hw::gui
