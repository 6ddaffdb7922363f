#pragma once
// Reads the kernel's files about a device, each of which has one fact.
#include <filesystem>
#include <fstream>
#include <string>

namespace hw {

/// The first line without trailing blanks; empty: the file does not exist.
inline std::string first_line(const std::filesystem::path& file) {
  std::string line;
  std::getline(std::ifstream(file), line);
  while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.pop_back();
  return line;
}

}  // namespace hw
