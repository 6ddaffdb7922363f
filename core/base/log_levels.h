#pragma once
// How much is logged below a path, for panels that show it. Any thread.
#include <optional>
#include <string_view>

#include "core/base/log.h"

namespace hw::log {

/// The level of a path and of all below it; none: they differ ("driver=warning,driver.vxm=debug"). Empty
/// path: of everything.
std::optional<Level> common_level(std::string_view path);

}  // namespace hw::log
