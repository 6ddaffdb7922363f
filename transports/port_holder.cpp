#include "transports/port_holder.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/core.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace hw {
namespace {

namespace fs = std::filesystem;

std::string describe(const std::string& proc, const std::string& process) {
  if (process == std::to_string(::getpid())) return std::string(this_program);
  std::string name;
  std::getline(std::ifstream(proc + "/" + process + "/comm"), name);
  return name.empty() ? fmt::format("process {}", process) : fmt::format("{} (process {})", name, process);
}

// Finds the process that has locked the device in /proc/locks, which every user may read: `1: FLOCK  ADVISORY
// WRITE 4182 00:1c:5 0 EOF`.
std::string locker(const std::string& proc, const struct stat& device) {
  const std::string place =
      fmt::format("{:02x}:{:02x}:{}", major(device.st_dev), minor(device.st_dev), device.st_ino);
  std::ifstream locks(proc + "/locks");
  for (std::string line; std::getline(locks, line);) {
    std::istringstream words(line);
    std::string number, kind, strength, access, process, where;
    words >> number >> kind >> strength >> access >> process >> where;
    if (kind == "FLOCK" && where == place) return process;
  }
  return {};
}

bool has_open(const fs::path& process, const std::string& device) {
  std::error_code error;
  for (const auto& fd : fs::directory_iterator(process / "fd", error))
    if (fs::read_symlink(fd.path(), error) == device) return true;
  return false;
}

std::string opener(const std::string& proc, const std::string& device) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(proc, error)) {
    const std::string process = entry.path().filename();
    if (!std::all_of(process.begin(), process.end(), [](unsigned char c) { return std::isdigit(c); }))
      continue;
    if (process != std::to_string(::getpid()) && has_open(entry.path(), device)) return process;
  }
  return {};
}

}  // namespace

std::string port_holder(const std::string& device, const std::string& proc) {
  std::error_code error;
  const std::string real = fs::canonical(device, error);
  struct stat there {};
  if (error || ::stat(real.c_str(), &there) != 0) return {};
  std::string process = locker(proc, there);
  if (process.empty()) process = opener(proc, real);
  return process.empty() ? std::string() : describe(proc, process);
}

}  // namespace hw
