#pragma once
// The meaning of traffic in plain words, for the terminal. Pure; any thread.
#include <string>
#include <string_view>

#include "core/link/traffic.h"

namespace hw::vme58 {

/// `asked`: the last text sent before a received entry. Returns an empty string if there is nothing to say.
std::string explain(std::string_view bytes, Way way, TrafficKind kind, std::string_view asked);

}  // namespace hw::vme58
