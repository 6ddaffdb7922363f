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
  /// The absolute targets that it names, but for those of an axis whose count it has set before.
  [[nodiscard]] virtual std::vector<AxisTarget> places_in(std::string_view text) const = 0;
};

}  // namespace hw
