#pragma once
// For languages whose texts name absolute targets in commands that no block describes: a second base class
// beside Language.
#include <string_view>
#include <vector>

#include "core/device/intent.h"

namespace hw {

class PlacesInText {
 public:
  virtual ~PlacesInText() = default;
  /// The absolute targets of program `start` and of all programs that it starts, except for axes whose count
  /// the text has set before.
  [[nodiscard]] virtual std::vector<AxisTarget> places_in(std::string_view text, int start) const = 0;
};

}  // namespace hw
