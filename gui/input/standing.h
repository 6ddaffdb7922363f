#pragma once
// Records since when each button that can start motion has been in its place, ready to be pressed: a press
// counts only on a button that has stood still for a while. A button that appears under a finger already on
// its way down was not meant. Stop, releases and everything that moves nothing never wait; the keyboard's
// focus ring means a button by its name, wherever it is.
#include <vector>

#include <imgui.h>

#include "gui/input/registry.h"

namespace hw::gui {

/// Time that a user who has seen a button move needs to withhold a press.
inline constexpr double must_stand_s = 0.3;

class Standing {
 public:
  struct Place {
    ImGuiID id = 0;
    Rect rect{};
    bool ready = false;            ///< enabled, and not covered by an open list or dialog
    bool came_alive = false;       ///< its last change: it became ready in place
    double since_s = 0;            ///< of the frame that first drew it so; of this one while it is not ready
    double not_taken_until_s = 0;  ///< shows until then that a press came too early
    bool seen = false;
    [[nodiscard]] bool too_early(double press_s) const { return press_s - since_s < must_stand_s; }
  };
  /// Once a frame for each drawn button. Valid until the next call.
  Place& see(ImGuiID id, const Rect& rect, bool ready, double now_s);
  /// Forgets the buttons that this frame did not draw: they start anew when they are drawn again.
  void end_frame();

 private:
  std::vector<Place> places_;  // a few dozen at most; allocates nothing once it has grown
};

}  // namespace hw::gui
