#pragma once
// Where a card may lie: it covers no control that may be needed.
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "gui/surface/ui.h"

namespace hw::panels {

class FreePlace {
 public:
  /// Notes what a card must not cover, as drawn in the last frame: controls that can start motion, Stops,
  /// other widgets that the user presses or types into (except an editor and rows of text), and the cards of
  /// rows above the card `own`.
  void look(std::span<const gui::Widget> widgets, std::string_view own);
  [[nodiscard]] bool leaves(const gui::Rect& place) const { return !blocker(place); }

  /// Where the upper edge of a card may be, and by how much it is moved at a time. Pixels.
  struct Band {
    float low, high, step;
  };
  /// The free place that is nearest to `wanted`, above or below it.
  [[nodiscard]] std::optional<gui::Rect> nearest(ImVec2 wanted, ImVec2 size, const Band& band) const;

 private:
  [[nodiscard]] const gui::Rect* blocker(const gui::Rect& place) const;
  [[nodiscard]] std::optional<float> steps_away(gui::Rect place, const Band& band, bool down) const;

  std::vector<gui::Rect> cards_, taken_;  ///< kept from frame to frame for their memory
};

}  // namespace hw::panels
