#pragma once
// What this computer knows of a port that is open or will not answer: how long its USB adapter holds bytes
// back, and who else has it open. Reads files of the system, some hundred of them: not for the io thread.
#include <optional>
#include <string>

#include "core/base/result.h"

namespace hw {

/// "/sys/bus/usb-serial/devices/ttyUSB0/latency_timer"; empty: the adapter has none, or it is no USB adapter.
std::string adapter_timer_file(const std::string& port, const std::string& sys = "/sys");
/// In milliseconds, from such a file.
std::optional<int> read_adapter_timer(const std::string& file);
[[nodiscard]] bool may_set_adapter_timer(const std::string& file);
/// Sets it and reads it back.
Result<> set_adapter_timer(const std::string& file, int milliseconds);

/// Another program that has the port open: "minicom (process 4182)". This program itself does not count.
/// Empty: none of those that this user may look into.
std::string other_user_of(const std::string& port, const std::string& proc = "/proc");

}  // namespace hw
