#pragma once
// Facts about a port that is open or does not answer: the latency timer of its USB adapter, and other
// programs that have it open. Reads some hundred system files: not for the io thread.
#include <optional>
#include <string>

#include "core/base/result.h"

namespace hw {

/// "/sys/bus/usb-serial/devices/ttyUSB0/latency_timer"; empty: no latency timer, or not a USB adapter.
std::string adapter_timer_file(const std::string& port, const std::string& sys = "/sys");
/// In milliseconds, from such a file.
std::optional<int> read_adapter_timer(const std::string& file);
[[nodiscard]] bool may_set_adapter_timer(const std::string& file);
/// Sets it and reads it back.
Result<> set_adapter_timer(const std::string& file, int milliseconds);

/// Another program that has the port open: "minicom (process 4182)". Empty: none among the processes that
/// this user may inspect.
std::string other_user_of(const std::string& port, const std::string& proc = "/proc");

}  // namespace hw
