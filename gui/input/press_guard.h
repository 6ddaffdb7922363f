#pragma once
// Accepts a press on a button that can start motion only when the button has been in its place, ready, for a
// while. The user did not mean a button that appears under a finger on its way down. Stop, releases and
// buttons that move nothing never wait. The keyboard does not wait either: the focus ring stays on its button
// when it moves.
#include <vector>

#include <imgui.h>

#include "gui/input/registry.h"

namespace hw::gui {

/// Time that a user needs to withhold a press after seeing a button move, in seconds.
inline constexpr double settle_time_s = 0.3;

class PressGuard {
 public:
  struct Button {
    ImGuiID id = 0;
    Rect rect{};
    bool ready = false;         ///< enabled, and not covered by an open list or dialog
    bool became_ready = false;  ///< its last change: it became ready without moving
    double since_s = 0;  ///< time of the frame that first drew it so, or of this frame while it is not ready
    double ignored_until_s = 0;  ///< until then the button shows that a press came too early
    bool seen = false;
    [[nodiscard]] bool too_early(double press_s) const { return press_s - since_s < settle_time_s; }
  };
  /// Call once in a frame for each drawn button. The reference is valid until the next call.
  Button& see(ImGuiID id, const Rect& rect, bool ready, double now_s);
  /// Forgets the buttons that this frame did not draw.
  void end_frame();

 private:
  std::vector<Button> buttons_;  // a few dozen at most; allocates nothing once it has grown
};

}  // namespace hw::gui
