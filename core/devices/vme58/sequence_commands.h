#pragma once
// Command strings as far as they go from steps to texts and back.
#include <string_view>
#include <vector>

#include "core/device/sequence_reading.h"
#include "core/devices/vme58/command_text.h"

namespace hw::vme58 {

[[nodiscard]] Deeds deeds_of(std::string_view text);

/// What commands in the middle of those for all axes may leave otherwise.
struct TextEffects {
  bool addresses = false;  ///< others than all axes
  bool moves = false, speeds = false, records = false;
};
[[nodiscard]] TextEffects effects_of(std::string_view text);

}  // namespace hw::vme58
