#pragma once
// Rows of a column of settings: what one is called, and beside it where it is chosen. At ImGui's cursor,
// which then stands below.
#include <string_view>

#include "gui/shell/frame.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

/// A number that counts as soon as it is one.
class NumberOption {
 public:
  /// 0: none, or the controller's own.
  [[nodiscard]] double value() const { return value_; }
  void set(double value, int decimals);
  /// True: it is another now. May be emptied where `least` is not above 0.
  bool draw(gui::Frame& frame, std::string_view id, std::string_view label, double least,
            std::string_view unit);

 private:
  gui::NumberField field_;
  double value_ = 0;
};

/// What an option is called; the cursor then stands where it is chosen. Returns where its row begins.
ImVec2 begin_option(gui::Ui& ui, std::string_view label);
void end_option(gui::Ui& ui, ImVec2 begun);
/// True: it is another now.
bool toggle_option(gui::Frame& frame, std::string_view id, std::string_view label, bool& value);

}  // namespace hw::panels
