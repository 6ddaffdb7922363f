#pragma once
// For languages with commands that only set speeds for later motions: a second base class beside Language.
#include <string_view>

namespace hw {

class SettingsInText {
 public:
  virtual ~SettingsInText() = default;
  /// Whether the text does nothing but set speeds and ramps: repeating the last of them restores its effect.
  [[nodiscard]] virtual bool only_sets(std::string_view text) const = 0;
};

}  // namespace hw
