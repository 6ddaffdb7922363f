#pragma once
// What is drawn over and under a path: rulers and grid, the table, the trace, the tool.
#include "gui/model/position_trace.h"
#include "gui/surface/ui.h"
#include "panels/path/path_subject.h"

namespace hw::panels {

/// Where it is drawn. For one frame.
struct PathGround {
  gui::Frame& frame;
  const PathSubject& subject;
  const drawing::PathView& view;
  gui::Rect whole, in;  ///< the canvas, and the view in it
  drawing::Box3 box;    ///< of all that is shown

  [[nodiscard]] ImVec2 at(drawing::Point3 p) const;
};

/// That tell numbers apart which lie so far from each other.
int decimals_of(double step);

/// Two axes: rulers at the border and lines across the view. Three: lines on the floor of what is shown, with
/// their numbers, and the axes at the origin.
void draw_grid(const PathGround& ground);
void draw_table(const PathGround& ground);
/// What the subject lights, and from where the tool is to where it is asked to go.
void draw_lit(const PathGround& ground);
/// Faded by age. All but the first `in_picture` points, and no more of them than a frame draws in no time.
void draw_trace(const PathGround& ground, const drawing::ToolPath& trace, std::size_t in_picture);
/// Registered as `id/here`.
void draw_here(const PathGround& ground, std::string_view id);

}  // namespace hw::panels
