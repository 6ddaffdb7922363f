#pragma once
// Helpers to convert sequence steps to command strings and back.
#include <string_view>
#include <vector>

#include "core/device/intent.h"
#include "core/device/sequence_reading.h"
#include "core/devices/vme58/command_text.h"

namespace hw::vme58 {

[[nodiscard]] Operations operations_of(std::string_view text);

/// The changes by a user's commands that affect the AA commands after them.
struct TextEffects {
  bool addresses = false;  ///< it addresses other axes than all
  bool moves = false, speeds = false, records = false;
};
[[nodiscard]] TextEffects effects_of(std::string_view text);

/// See PlacesInText. The targets of contours are not among them.
[[nodiscard]] std::vector<AxisTarget> places_of_text(std::string_view text);

}  // namespace hw::vme58
