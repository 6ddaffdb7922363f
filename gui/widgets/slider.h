#pragma once
// The speed slider: a line with a grip of 16 x 24. The mouse drags the grip or clicks on the line; + and -
// step a focused slider.
#include <string_view>

#include "gui/widgets/touch.h"

namespace hw::gui {

struct SliderOptions {
  double min = 0, max = 1;
  double step = 0;           ///< step of + and -, to which values are rounded; 0: a hundredth of the range
  double normal = -1;        ///< a double click sets it if it is within the range
  bool logarithmic = false;  ///< for speeds over decades; `min` must be above 0
  std::string_view disabled = {};
  std::string_view tip = {};
  std::string_view value_text = {};  ///< for scripts and readers
  float width = fill;
};
/// True when `value` changed in this frame.
bool slider(Ui& ui, std::string_view id, std::string_view label, double& value, const SliderOptions& options);

/// 8 high, radius 2; the panel writes the numbers beside it.
struct MeterOptions {
  Tone tone = Tone::ink2;       ///< motion for progress
  bool over = false;            ///< more than full: fault
  bool old = false;             ///< not up to date: line
  std::string_view words = {};  ///< for scripts: "27 of 256 bytes"
  std::string_view tip = {};
  float width = fill, height = 8;
};
void meter(Ui& ui, std::string_view id, std::string_view label, float share,
           const MeterOptions& options = {});

}  // namespace hw::gui
