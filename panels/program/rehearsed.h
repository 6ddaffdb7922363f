#pragma once
// Whether Run would run the text as rehearsed, from the present state of the controller.
#include <string_view>

#include "gui/shell/frame.h"

namespace hw::panels {

struct Rehearsed {
  bool holds = false;      ///< this text, from here, without findings
  std::string_view words;  ///< else what has changed since, or what was found
};
[[nodiscard]] Rehearsed rehearsed(const gui::Frame& frame, int slot);

}  // namespace hw::panels
