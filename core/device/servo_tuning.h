#pragma once
// Conventions between a controller with Capabilities::servo_tuning and the console, besides intent::Sample.
#include <string_view>

namespace hw {

/// Heading (ParamInfo::group) of an axis' gains, which can be changed between two recorded steps.
inline constexpr std::string_view servo_loop_group = "Servo loop";

}  // namespace hw
