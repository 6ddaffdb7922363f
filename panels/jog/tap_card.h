#pragma once
// Beside the pad, why a tap was refused that would have gone past a limit, with the way to the limit itself.
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
