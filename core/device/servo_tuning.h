#pragma once
// What a controller with Capabilities::servo_tuning and its console agree on, beside intent::Sample.
#include <string_view>

namespace hw {

/// Heading (ParamInfo::group) of the gains of an axis: what can be changed between two recorded steps.
inline constexpr std::string_view servo_loop_group = "Servo loop";

}  // namespace hw
