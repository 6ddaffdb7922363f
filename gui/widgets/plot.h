#pragma once
// Traces over a common axis, time or position, with a grid, names at the traces, and a cursor that shows the
// values under the mouse. At rest a plot allocates no memory: the panel owns the traces, and at most two
// points are drawn per column of pixels.
#include <cstddef>
#include <span>
#include <string_view>

#include "gui/widgets/touch.h"

namespace hw::gui {

struct PlotTrace {
  std::span<const float> x, y;  ///< x grows
  Tone tone = Tone::ink;
  float width = 1;  ///< logical
  bool dashed = false;
  std::string_view name = {};  ///< drawn at the end of the trace; empty: no name
  bool name_above = false;
  std::span<const std::size_t> gaps = {};  ///< indices of the points with a gap before them, in order
};
/// A dotted vertical line with words beside it.
struct PlotMark {
  float x = 0;
  std::string_view words = {};
};

struct PlotRange {
  float min = 0, max = 1;
  /// Adds `share` of the range above and below. The range is never empty afterwards.
  void widen(float share);
  void take(std::span<const float> values);
  [[nodiscard]] float share(float value) const { return (value - min) / (max - min); }
};

struct PlotOptions {
  std::string_view title = {};  ///< "position, counts"
  std::string_view x_unit = {};
  PlotRange x, y;
  std::span<const PlotMark> marks = {};
  PlotRange band{0, 0};         ///< in `raised`; empty: none
  bool x_labels = true;         ///< false: drawn above another plot of the same x
  std::string_view words = {};  ///< content, for scripts
  std::string_view empty = {};  ///< shown while there is nothing to draw
  float width = fill, height = 160;
};

/// The cursor under the mouse, shared by the plots of a group: all of them show it.
struct PlotCursor {
  bool shown = false;
  float x = 0;
  std::size_t of = 0;  ///< the plot that the mouse is over
};

/// Draws at ImGui's cursor. Ids: `id`, and `id/cursor` while the mouse is over the plot. Plots below each
/// other share `cursor`; the plot under the mouse sets it.
void plot(Ui& ui, std::string_view id, std::string_view label, std::span<const PlotTrace> traces,
          const PlotOptions& options, PlotCursor& cursor);

/// The distance of grid lines: 1, 2 or 5 times a power of ten, with at most `most` lines over the range.
double grid_step(PlotRange range, int most);
/// The value of a trace at `x`, interpolated; false outside of the trace.
bool value_at(const PlotTrace& trace, float x, float& value);

}  // namespace hw::gui
