#pragma once
// The sheet that the badge at the jog pad opens. It describes the guard in the controller itself: its effect,
// where it is stored, and which facts are unknown. Installs and removes the guard on all devices that the pad
// jogs. Ids: `jog/guard/state`, `jog/guard/install`, `jog/guard/remove`, `jog/guard/close`.
#include <string_view>

#include "gui/shell/frame.h"

namespace hw::panels {

class GuardOffer {
 public:
  void open() { open_ = true; }
  /// Call in each frame. Draws nothing while closed.
  void draw(gui::Frame& frame);

 private:
  void draw_buttons(gui::Frame& frame, bool installed);

  bool open_ = false;
};

}  // namespace hw::panels
