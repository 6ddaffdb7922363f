#pragma once
// Draws the parts above and below a path: rulers and grid, the table, the trace, the tool.
#include "gui/model/position_trace.h"
#include "gui/surface/ui.h"
#include "panels/path/path_progress.h"
#include "panels/path/path_subject.h"

namespace hw::panels {

/// The drawing target. Valid for one frame.
struct PathGround {
  gui::Frame& frame;
  const PathSubject& subject;
  const drawing::PathView& view;
  gui::Rect whole, in;  ///< the canvas, and the view in it
  drawing::Box3 box;    ///< box around the whole content

  [[nodiscard]] ImVec2 at(drawing::Point3 p) const;
};

/// Decimals that distinguish numbers `step` apart.
int decimals_of(double step);
/// A round spacing for lines at least `apart_px` apart, over a range that is `px` wide on the screen.
double step_over(double range, float px, float apart_px);

/// The width in pixels of the widest number on the ruler of the second axis.
float width_of_numbers(const gui::Ui& ui, const drawing::PathView& view);
/// Draws rulers at the border and lines across the view for two axes, numbered lines on the floor of the box
/// for three.
void draw_grid(const PathGround& ground);
/// For three axes: draws the origin and the name of each axis, above all other parts.
void draw_origin(const PathGround& ground);
void draw_table(const PathGround& ground);
/// Draws the way from the tool to its requested position.
void draw_way_there(const PathGround& ground);
/// Draws the highlighted runs; a run in progress only up to the tool.
void draw_lit(const PathGround& ground, PathProgress& progress);
/// Draws the trace, faded by age. Skips the first `in_picture` points, and draws only as many as do not delay
/// a frame.
void draw_trace(const PathGround& ground, const drawing::ToolPath& trace, std::size_t in_picture);
/// Draws the tool, registered as `id/here`.
void draw_here(const PathGround& ground, std::string_view id);

}  // namespace hw::panels
