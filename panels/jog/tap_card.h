#pragma once
// Shows beside the pad why a tap that leads past a limit was refused, and offers to move to the limit itself.
#include "gui/shell/frame.h"
#include "panels/refusal_card.h"

namespace hw::panels {

class TapCard {
 public:
  void draw(gui::Frame& frame, const gui::Rect& pad);

 private:
  void draw(gui::Frame& frame, gui::Tab& tab, const gui::Rect& pad);

  RefusalCard card_;
};

}  // namespace hw::panels
