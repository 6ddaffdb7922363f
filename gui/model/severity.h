#pragma once
#include <cstdint>

namespace hw::gui {

/// Colour and shape of a message; its words stand on their own.
enum class Severity : std::uint8_t { plain, ok, motion, warn, fault };

}  // namespace hw::gui
