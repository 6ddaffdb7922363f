#pragma once
// Since when each button that can start motion has stood where it stands, ready to be pressed: a press counts
// only on one that has stood still for a while. What comes under a hand that is already on its way down is
// not what the hand meant. Stop, letting go and everything that moves nothing never wait; the keyboard's
// focus ring means a button by its name, wherever it is.
#include <vector>

#include <imgui.h>

#include "gui/input/registry.h"

namespace hw::gui {

/// A hand that has seen a button move needs about that long to take its press back.
inline constexpr double must_stand_s = 0.3;

class Standing {
 public:
  struct Place {
    ImGuiID id = 0;
    Rect rect{};
    bool ready = false;            ///< enabled, and no list or dialog is open over it
    bool came_alive = false;       ///< what changed last: it became ready where it stood
    double since_s = 0;            ///< of the frame that first drew it so; of this one while it is not ready
    double not_taken_until_s = 0;  ///< till then it shows that a press came too early
    bool seen = false;
    [[nodiscard]] bool too_early(double press_s) const { return press_s - since_s < must_stand_s; }
  };
  /// Once a frame for each that is drawn. Valid until the next call.
  Place& see(ImGuiID id, const Rect& rect, bool ready, double now_s);
  /// What this frame did not draw is forgotten: it has not stood still when it comes again.
  void end_frame();

 private:
  std::vector<Place> places_;  // a few dozen at most; allocates nothing once it has grown
};

}  // namespace hw::gui
