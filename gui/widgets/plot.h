#pragma once
// Traces over a common axis: time as a rule, a position in others. Grid, names at the traces, a cursor under
// the mouse that tells the values there. Allocates nothing at rest: traces are the panel's own memory, and no
// more than two points are drawn in a column of pixels.
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
  float longest_joined = 0;  ///< points further apart have a gap between them; 0: all are joined
};
/// A dotted line up and down with words beside it.
struct PlotMark {
  float x = 0;
  std::string_view words = {};
};

struct PlotRange {
  float min = 0, max = 1;
  /// With a little air above and below; never empty.
  void widen(float share);
  void take(std::span<const float> values);
  [[nodiscard]] float share(float value) const { return (value - min) / (max - min); }
};

struct PlotOptions {
  std::string_view title = {};  ///< "position, counts"
  std::string_view x_unit = {}, y_unit = {};
  PlotRange x, y;
  std::span<const PlotMark> marks = {};
  PlotRange band{0, 0};         ///< in `raised`; empty: none
  bool x_labels = true;         ///< false: stands above another plot of the same x
  std::string_view words = {};  ///< for scripts: what it shows
  std::string_view empty = {};  ///< said while there is nothing to draw
  float width = fill, height = 160;
};

/// Where the mouse points, and where it points within the plots of one group: the cursor goes through all.
struct PlotCursor {
  bool shown = false;
  float x = 0;
  std::size_t of = 0;  ///< the plot that the mouse is over
};

/// At ImGui's cursor. Ids: `id`, and `id/cursor` while the mouse is over it. `cursor` is shared by plots that
/// stand under each other; each sets it while the mouse is over it.
void plot(Ui& ui, std::string_view id, std::string_view label, std::span<const PlotTrace> traces,
          const PlotOptions& options, PlotCursor& cursor);

/// 1, 2 or 5 times a power of ten: at most `most` lines over the range.
double grid_step(PlotRange range, int most);
/// The value of a trace at `x`, between its points; false outside of it.
bool value_at(const PlotTrace& trace, float x, float& value);

}  // namespace hw::gui
