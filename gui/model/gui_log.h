#pragma once
// Log of what the console decides by itself: presses that it does not take, holds that it ends. --log
// gui=debug.
#include "core/base/log.h"

namespace hw::gui {

inline log::Subject& gui_log() {
  static log::Subject& one = log::subject("gui");
  return one;
}

}  // namespace hw::gui
