#pragma once
// Possible values of a placeholder on the command line ("FILE.toml", "MODEL", "real|off").
#include <string>
#include <string_view>

namespace hw::app {

struct Completed {
  std::string words;      ///< these, with spaces between
  bool files = false;     ///< or any file
  bool folders = false;   ///< or any folder
  std::string extension;  ///< of those files, "toml"; empty: all
};

Completed completed(std::string_view placeholder);

}  // namespace hw::app
