#pragma once
// A row of what is found: mark, name, facts under it, a word for its state, and the buttons at its right.
#include <string_view>

#include "gui/surface/ui.h"
#include "gui/widgets/button.h"

namespace hw::panels {

struct PlaceRow {
  gui::Icon mark = gui::Icon::ring;
  gui::Tone tone = gui::Tone::ink2;
  std::string_view title, facts, state = {};
  gui::Tone state_tone = gui::Tone::ink2;
  bool chosen = false;  ///< its card is unfolded
};

constexpr float place_mark = 28;  ///< logical, from the row's left to its words

/// Draws at ImGui's cursor, `buttons` logical kept free at the right; returns the height in pixels: two lines
/// of facts where it takes them. The cursor stays.
float draw_place_row(gui::Ui& ui, const PlaceRow& row, float width, float buttons);

/// Buttons of a row, from its right edge to the left. Each is drawn where it is called.
class RowButtons {
 public:
  RowButtons(gui::Ui& ui, float width);
  /// True when it was pressed. `width` logical.
  bool press(std::string_view id, std::string_view label, float width, gui::ButtonOptions options = {});
  /// Places what is drawn next.
  void stand(float width);

 private:
  gui::Ui& ui_;
  ImVec2 at_;
  float right_;
};

/// Of an address, for a person: without "/dev/".
std::string_view short_place(std::string_view where);

}  // namespace hw::panels
