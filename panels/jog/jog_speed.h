#pragma once
// Shows the speed of a held jog: a slider for all axes, and a number that opens a field for exact values, or
// a field for each axis where units or speeds differ.
#include <vector>

#include "gui/model/units_format.h"
#include "gui/shell/panel_entry.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

class JogSpeed {
 public:
  /// `roomy`: the words are above the slider, else beside it.
  void draw(gui::Frame& frame, bool roomy);
  /// Draws it in one line, at the cursor.
  void draw_line(gui::Frame& frame, float width);
  /// Why the typed speed is invalid; empty: it is valid, or none is typed.
  [[nodiscard]] std::string_view flaw() const { return typing_ ? field_.sentence : std::string_view(); }

 private:
  void draw_slider(gui::Frame& frame, float width);
  void draw_number(gui::Frame& frame, ImVec2 at, float width, float height);
  void draw_field(gui::Frame& frame, float width, float height);
  void draw_axes(gui::Frame& frame, const gui::Touch& opener);
  static void draw_axis(gui::Frame& frame, gui::Tab& tab, AxisId axis, gui::NumberField& field);
  void begin_typing(gui::Frame& frame);

  gui::NumberField field_;
  std::vector<gui::NumberField> fields_;  ///< fields of the axes
  bool typing_ = false, was_typing_ = false;
};

}  // namespace hw::panels
