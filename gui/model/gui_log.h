#pragma once
// Log of the console's own decisions: ignored presses, ended holds. --log gui=debug.
#include "core/base/log.h"

namespace hw::gui {

inline log::Subject& gui_log() {
  static log::Subject& one = log::subject("gui");
  return one;
}

}  // namespace hw::gui
