#include "transports/port_facts.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>

#include <fmt/core.h>
#include <unistd.h>

#include "transports/sysfs.h"

namespace hw {
namespace fs = std::filesystem;

std::string adapter_timer_file(const std::string& port, const std::string& sys) {
  std::error_code error;
  const fs::path real = fs::canonical(port, error);
  const std::string name = (error ? fs::path(port) : real).filename();
  const std::string file = fmt::format("{}/bus/usb-serial/devices/{}/latency_timer", sys, name);
  return !name.empty() && fs::exists(file, error) ? file : std::string();
}

std::optional<int> read_adapter_timer(const std::string& file) {
  if (file.empty()) return {};
  const std::string line = first_line(file);
  int value = 0;
  const auto read = std::from_chars(line.data(), line.data() + line.size(), value);
  if (read.ec != std::errc() || value < 0) return {};
  return value;
}

bool may_set_adapter_timer(const std::string& file) {
  return !file.empty() && ::access(file.c_str(), W_OK) == 0;
}

Result<> set_adapter_timer(const std::string& file, int milliseconds) {
  const auto before = read_adapter_timer(file);
  std::ofstream(file) << milliseconds << "\n";
  const auto now = read_adapter_timer(file);
  if (now == milliseconds) return {};
  return fail(FaultKind::port,
              fmt::format("The latency timer of the USB adapter was not set to {} ms.", milliseconds),
              now      ? fmt::format("It stands at {} ms.", *now)
              : before ? "It cannot be read any more."
                       : "",
              fmt::format("Type: echo {} | sudo tee {}", milliseconds, file));
}

static bool process_has_open(const fs::path& process, const std::string& device) {
  std::error_code error;
  for (const auto& fd : fs::directory_iterator(process / "fd", error))
    if (fs::read_symlink(fd.path(), error) == device) return true;
  return false;
}

std::string other_user_of(const std::string& port, const std::string& proc) {
  std::error_code error;
  const std::string real = fs::canonical(port, error);
  if (error) return {};
  const std::string own = std::to_string(::getpid());
  for (const auto& entry : fs::directory_iterator(proc, error)) {
    const std::string process = entry.path().filename();
    if (process == own || process.find_first_not_of("0123456789") != process.npos) continue;
    if (!process_has_open(entry.path(), real)) continue;
    const std::string name = first_line(entry.path() / "comm");
    return name.empty() ? fmt::format("process {}", process) : fmt::format("{} (process {})", name, process);
  }
  return {};
}

}  // namespace hw
