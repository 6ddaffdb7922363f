#pragma once
// The values that a placeholder of the command line can have ("FILE.toml", "MODEL", "real|off").
#include <string>
#include <string_view>

namespace hw::app {

struct Completed {
  std::string words;      ///< these words, with spaces between
  bool ports = false;     ///< serial ports, or any file
  bool files = false;     ///< files are possible too
  bool folders = false;   ///< folders are possible too
  std::string extension;  ///< extension of those files, "toml"; empty: any
};

Completed completed(std::string_view placeholder);

}  // namespace hw::app
