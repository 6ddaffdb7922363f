#pragma once
// Texts that address one axis throughout ("AX MR100 GO"), as the same commands in lists of all axes
// ("AA MR100; GO"), which steps are written as.
#include <optional>
#include <string>
#include <string_view>

namespace hw::vme58 {

/// On the same lines, with its comments. None: the text addresses several axes, begins before it has
/// addressed any, or holds a command that means something else in a list.
[[nodiscard]] std::optional<std::string> in_lists(std::string_view text);

}  // namespace hw::vme58
