#pragma once
// A button that acts while held, such as a jog button. Releasing it ends the hold; moving the mouse off it
// does not. It does not repeat.
#include <string_view>

#include "gui/widgets/icons.h"
#include "gui/widgets/touch.h"

namespace hw::gui {

struct HoldOptions {
  Icon icon = Icon::none;
  std::string_view disabled = {};
  std::string_view tip = {};
  float width = 56, height = 56;  ///< logical; 48 in medium windows
  bool moving = true;             ///< false: front panel buttons of a bench
  bool stops = false;             ///< a Stop: fault outline and words
  bool lit = false;               ///< held by other means (a key): drawn as held
};

struct Hold {
  Touch touch;
  /// `ended` may come without `started` (pressed while disabled): stopping an axis at rest is harmless.
  bool started = false;  ///< this frame
  bool held = false;
  bool ended = false;                          ///< this frame; also when it became disabled while held
  double pressed_at_s = 0, released_at_s = 0;  ///< of the input: to distinguish a tap from a hold
};

Hold hold_button(Ui& ui, std::string_view id, std::string_view label, const HoldOptions& options = {});

}  // namespace hw::gui
