#pragma once
// Finds facts about a port that is open or does not answer: the latency timer of its USB adapter, and other
// programs that have it open. Reads some hundred system files, so do not call it on the io thread.
#include <optional>
#include <string>

#include "core/base/result.h"

namespace hw {

/// The file of the latency timer: "/sys/bus/usb-serial/devices/ttyUSB0/latency_timer"; empty: no latency
/// timer, or not a USB adapter.
std::string adapter_timer_file(const std::string& port, const std::string& sys = "/sys");
/// Reads the timer from such a file, in milliseconds.
std::optional<int> read_adapter_timer(const std::string& file);
[[nodiscard]] bool may_set_adapter_timer(const std::string& file);
/// Sets the timer and reads it back.
Result<> set_adapter_timer(const std::string& file, int milliseconds);

/// Another program that has the port open: "minicom (process 4182)"; empty: none of the processes that this
/// user may inspect.
std::string other_user_of(const std::string& port, const std::string& proc = "/proc");

}  // namespace hw
