#pragma once
// How fast a held jog goes: a slider for the hand, and behind its number a field for who knows what he wants.
#include "gui/model/units_format.h"
#include "gui/shell/panel_entry.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

class JogSpeed {
 public:
  /// `roomy`: the words stand over the slider, else beside it.
  void draw(gui::Frame& frame, bool roomy);
  /// At the cursor, all in one line.
  void draw_line(gui::Frame& frame, float width);
  /// Why the speed that is typed does not go; empty: it does, or none is typed.
  [[nodiscard]] std::string_view flaw() const { return typing_ ? field_.sentence : std::string_view(); }

 private:
  void draw_slider(gui::Frame& frame, float width);
  void draw_number(gui::Frame& frame, ImVec2 at, float width, float height);
  void draw_field(gui::Frame& frame, float width, float height);
  void begin_typing(gui::Frame& frame);

  gui::NumberField field_;
  bool typing_ = false, was_typing_ = false;
};

}  // namespace hw::panels
