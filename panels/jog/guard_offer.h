#pragma once
// The sheet behind the badge by the jog pad: a guard in the controller itself, with what it does, where it is
// kept and what is not known of it; installed and taken away here. Of all devices that the pad jogs. Ids:
// `jog/guard/state`, `jog/guard/install`, `jog/guard/remove`, `jog/guard/close`.
#include <string_view>

#include "gui/shell/frame.h"

namespace hw::panels {

class GuardOffer {
 public:
  void open() { open_ = true; }
  /// Each frame; nothing is drawn while it is closed.
  void draw(gui::Frame& frame);

 private:
  void draw_buttons(gui::Frame& frame, bool installed);

  bool open_ = false;
};

}  // namespace hw::panels
