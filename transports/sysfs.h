#pragma once
// Reads the kernel's files about a device, one fact a file.
#include <filesystem>
#include <fstream>
#include <string>

namespace hw {

/// The first line without trailing blanks; empty: no such file.
inline std::string first_line(const std::filesystem::path& file) {
  std::string line;
  std::getline(std::ifstream(file), line);
  while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.pop_back();
  return line;
}

}  // namespace hw
