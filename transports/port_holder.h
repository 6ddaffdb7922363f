#pragma once
#include <string>
#include <string_view>

namespace hw {

/// The name that port_holder() gives to the program that asks.
inline constexpr std::string_view this_program = "this program itself";

/// The program that holds a device file: "minicom (process 4182)"; empty: unknown to /proc. A program that
/// has locked the file takes precedence over a program that has it open.
std::string port_holder(const std::string& device, const std::string& proc = "/proc");

}  // namespace hw
