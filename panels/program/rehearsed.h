#pragma once
// Whether what Run would run is what has been rehearsed, from the controller as it is now.
#include <string_view>

#include "gui/shell/frame.h"

namespace hw::panels {

struct Rehearsed {
  bool holds = false;      ///< this text, from here, and nothing was found in its way
  std::string_view words;  ///< else what has changed since, or what was found
};
[[nodiscard]] Rehearsed rehearsed(const gui::Frame& frame, int slot);

}  // namespace hw::panels
