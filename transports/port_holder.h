#pragma once
#include <string>

namespace hw {

/// Which program holds a device file: "minicom (process 4182)"; empty when /proc does not tell. One that has
/// locked it comes before one that merely has it open.
std::string port_holder(const std::string& device, const std::string& proc = "/proc");

}  // namespace hw
