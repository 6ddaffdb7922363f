#pragma once
// Of languages whose texts name absolute targets in commands that no block describes: a second base class
// beside Language.
#include <string_view>
#include <vector>

#include "core/device/intent.h"

namespace hw {

class PlacesInText {
 public:
  virtual ~PlacesInText() = default;
  /// The absolute targets of its program `start` and of all that this one starts, but for those of an axis
  /// whose count has been set before.
  [[nodiscard]] virtual std::vector<AxisTarget> places_in(std::string_view text, int start) const = 0;
};

}  // namespace hw
