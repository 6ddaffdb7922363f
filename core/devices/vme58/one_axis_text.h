#pragma once
// Texts that address one axis throughout ("AX MR100 GO"), as the same commands in lists of all axes
// ("AA MR100; GO"), which steps are written as.
#include <optional>
#include <string>
#include <string_view>

namespace hw::vme58 {

/// The text on the same lines, with its comments. None: it addresses several axes, has a command before it
/// addresses any, or has a command with another meaning in a list.
[[nodiscard]] std::optional<std::string> in_lists(std::string_view text);

}  // namespace hw::vme58
