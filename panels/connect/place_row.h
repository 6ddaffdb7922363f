#pragma once
// Draws a row of the list of places: mark, name, facts below it, a word for its state, and buttons at the
// right.
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

/// Draws at ImGui's cursor. Keeps `buttons` logical pixels free at the right. Returns the height in pixels,
/// because the facts may take two lines. The cursor stays.
float draw_place_row(gui::Ui& ui, const PlaceRow& row, float width, float buttons);

/// Draws the buttons of a row from its right edge to the left, in the order of the calls.
class RowButtons {
 public:
  RowButtons(gui::Ui& ui, float width);
  /// Returns true when the button was pressed. `width` is logical.
  bool press(std::string_view id, std::string_view label, float width, gui::ButtonOptions options = {});
  /// Moves the cursor to the place of the next item.
  void stand(float width);

 private:
  gui::Ui& ui_;
  ImVec2 at_;
  float right_;
};

/// A place for display, without "/dev/".
std::string_view short_place(std::string_view where);

}  // namespace hw::panels
