#pragma once
// What the kernel says of a device, one file a fact.
#include <filesystem>
#include <fstream>
#include <string>

namespace hw {

/// The first line without the blanks at its end; empty when there is no such file.
inline std::string first_line(const std::filesystem::path& file) {
  std::string line;
  std::getline(std::ifstream(file), line);
  while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.pop_back();
  return line;
}

}  // namespace hw
