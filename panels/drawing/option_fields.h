#pragma once
// Rows of a settings column: a label, and the control beside it. Drawn at ImGui's cursor, which then stands
// below.
#include <initializer_list>
#include <string>
#include <string_view>

#include "gui/shell/frame.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

/// A number that takes effect once it is valid. Until then the previous value applies, and wrong() says what
/// to correct.
class NumberOption {
 public:
  /// 0: none, or the controller's own.
  [[nodiscard]] double value() const { return value_; }
  /// "Tolerance: this is not a number."; empty: valid.
  [[nodiscard]] const std::string& wrong() const { return wrong_; }
  void set(double value, int decimals);
  /// True: changed. May be empty unless `least` is above 0.
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

/// Draws the label; the cursor then stands at the control. Returns where the row begins.
ImVec2 begin_option(gui::Ui& ui, std::string_view label, gui::Tone tone = gui::Tone::ink2);
void end_option(gui::Ui& ui, ImVec2 begun);
/// True: changed.
bool toggle_option(gui::Frame& frame, std::string_view id, std::string_view label, bool& value);

}  // namespace hw::panels
