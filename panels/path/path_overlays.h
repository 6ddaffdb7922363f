#pragma once
// Everything drawn over and under a path: rulers and grid, the table, the trace, the tool.
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
  drawing::Box3 box;    ///< of everything shown

  [[nodiscard]] ImVec2 at(drawing::Point3 p) const;
};

/// Decimals that distinguish numbers `step` apart.
int decimals_of(double step);
/// A round spacing for lines over this range of so many pixels, at least `apart_px` apart.
double step_over(double range, float px, float apart_px);

/// Of the widest number on the ruler of the second axis; px.
float width_of_numbers(const gui::Ui& ui, const drawing::PathView& view);
/// Two axes: rulers at the border and lines across the view. Three: numbered lines on the floor of the box.
void draw_grid(const PathGround& ground);
/// Three axes: the origin and name of each, over everything else.
void draw_origin(const PathGround& ground);
void draw_table(const PathGround& ground);
/// From the tool to its requested position.
void draw_way_there(const PathGround& ground);
/// Draws the highlighted runs; of the one in progress only up to the tool.
void draw_lit(const PathGround& ground, PathProgress& progress);
/// Faded by age. Skips the first `in_picture` points, and draws no more than fit into a frame without delay.
void draw_trace(const PathGround& ground, const drawing::ToolPath& trace, std::size_t in_picture);
/// Registered as `id/here`.
void draw_here(const PathGround& ground, std::string_view id);

}  // namespace hw::panels
