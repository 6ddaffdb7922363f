#pragma once
// Traces over a common axis: usually time, otherwise a position. Grid, names at the traces, a cursor under
// the mouse that shows the values there. Allocates nothing at rest: traces are the panel's memory, and at
// most two points are drawn per column of pixels.
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
  std::string_view name = {};  ///< at its end; empty: only drawn
  bool name_above = false;
  std::span<const std::size_t> gaps = {};  ///< the points with a gap before them, in order
};
/// A dotted vertical line with words beside it.
struct PlotMark {
  float x = 0;
  std::string_view words = {};
};

struct PlotRange {
  float min = 0, max = 1;
  /// Adds some room above and below; never empty.
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

/// The mouse position, shared by the plots of one group: the cursor goes through all.
struct PlotCursor {
  bool shown = false;
  float x = 0;
  std::size_t of = 0;  ///< the plot that the mouse is over
};

/// Draws at ImGui's cursor. Ids: `id`, and `id/cursor` while the mouse is over it. `cursor` is shared by
/// plots under each other; each sets it while the mouse is over it.
void plot(Ui& ui, std::string_view id, std::string_view label, std::span<const PlotTrace> traces,
          const PlotOptions& options, PlotCursor& cursor);

/// 1, 2 or 5 times a power of ten: at most `most` lines over the range.
double grid_step(PlotRange range, int most);
/// The value of a trace at `x`, interpolated; false outside of the trace.
bool value_at(const PlotTrace& trace, float x, float& value);

}  // namespace hw::gui
