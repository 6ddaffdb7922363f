#pragma once
// Draws rows of a settings column: a label with a control beside it, at ImGui's cursor. The cursor is below
// afterwards.
#include <initializer_list>
#include <string>
#include <string_view>

#include "gui/shell/frame.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

/// A number that takes effect when it is valid. Until then the previous value applies, and wrong() says how
/// to correct the input.
class NumberOption {
 public:
  /// The value; 0: none, or the controller's own.
  [[nodiscard]] double value() const { return value_; }
  /// "Tolerance: this is not a number."; empty: valid.
  [[nodiscard]] const std::string& wrong() const { return wrong_; }
  void set(double value, int decimals);
  /// Returns true when the value has changed. The field may be empty unless `least` is above 0.
  bool draw(gui::Frame& frame, std::string_view id, std::string_view label, double least,
            std::string_view unit, int decimals = 6);

 private:
  gui::NumberField field_;
  double value_ = 0;
  std::string shown_;  ///< the value as the field shows it, perhaps rounded
  std::string wrong_;
};
/// wrong() of the first invalid option; empty: all are valid.
std::string first_wrong(std::initializer_list<const NumberOption*> options);

/// Draws the label. The cursor is at the control afterwards. Returns the begin of the row.
ImVec2 begin_option(gui::Ui& ui, std::string_view label, gui::Tone tone = gui::Tone::ink2);
void end_option(gui::Ui& ui, ImVec2 begun);
/// Returns true when it was switched.
bool toggle_option(gui::Frame& frame, std::string_view id, std::string_view label, bool& value);

}  // namespace hw::panels
