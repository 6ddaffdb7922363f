#pragma once
// Rows of a column of settings: what one is called, and beside it where it is chosen. At ImGui's cursor,
// which then stands below.
#include <initializer_list>
#include <string>
#include <string_view>

#include "gui/shell/frame.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

/// A number that counts as soon as it is one. Until then the one before counts, and wrong() says what is to
/// be mended.
class NumberOption {
 public:
  /// 0: none, or the controller's own.
  [[nodiscard]] double value() const { return value_; }
  /// "Tolerance: this is not a number."; empty: it is one.
  [[nodiscard]] const std::string& wrong() const { return wrong_; }
  void set(double value, int decimals);
  /// True: it is another now. May be emptied where `least` is not above 0.
  bool draw(gui::Frame& frame, std::string_view id, std::string_view label, double least,
            std::string_view unit);

 private:
  gui::NumberField field_;
  double value_ = 0;
  std::string told_;  ///< the value as the field has it, which may be shorter
  std::string wrong_;
};
/// Of the first that has any; empty: all of them are numbers.
std::string first_wrong(std::initializer_list<const NumberOption*> options);

/// What an option is called; the cursor then stands where it is chosen. Returns where its row begins.
ImVec2 begin_option(gui::Ui& ui, std::string_view label, gui::Tone tone = gui::Tone::ink2);
void end_option(gui::Ui& ui, ImVec2 begun);
/// True: it is another now.
bool toggle_option(gui::Frame& frame, std::string_view id, std::string_view label, bool& value);

}  // namespace hw::panels
