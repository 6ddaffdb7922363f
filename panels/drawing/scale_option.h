#pragma once
// The scale of an axis, in the form that the user knows: steps in a length, or the length of a step.
#include <cstdint>
#include <string_view>

#include "panels/drawing/option_fields.h"
#include "panels/widget_path.h"

namespace hw::panels {

enum class ScaleForm : std::uint8_t { steps_in_mm, mm_per_step, steps_in_inch, inches_per_step };
inline constexpr int scale_forms = 4;

/// "pulses/mm", "mm/pulse" ...
[[nodiscard]] Path words_of(ScaleForm form, std::string_view step_word);

class ScaleOption {
 public:
  /// The steps in a mm, whatever the form.
  [[nodiscard]] double value() const { return steps_in_mm_; }
  [[nodiscard]] const NumberOption& field() const { return field_; }
  void set(double steps_in_mm, ScaleForm form);
  [[nodiscard]] ScaleForm form() const { return form_; }
  /// Returns true when the scale has changed.
  bool draw(gui::Frame& frame, std::string_view id, std::string_view axis);

 private:
  NumberOption field_;
  double steps_in_mm_ = 0;
  ScaleForm form_ = ScaleForm::steps_in_mm;
};

}  // namespace hw::panels
