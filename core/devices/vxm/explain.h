#pragma once
// The meaning of traffic in plain words, for the terminal. Pure; any thread.
#include <string>
#include <string_view>

#include "core/link/traffic.h"

namespace hw::vxm {

struct TextCommand;

/// `asked`: the bytes sent last before a received entry. Returns empty: nothing to explain.
std::string explain(std::string_view bytes, Way way, TrafficKind kind, std::string_view asked);
/// "store: motor 1 moves by +400 steps"
std::string explain_command(const TextCommand& command);

}  // namespace hw::vxm
