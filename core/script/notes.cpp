#include "core/script/notes.h"

namespace hw::script {

std::string Written::sentence() const {
  std::string all;
  for (const auto& [path, what] : files_) {
    all += (all.empty() ? "Wrote " : ", ") + path;
    if (!what.empty()) all += " (" + what + ")";
  }
  return all.empty() ? all : all + ".";
}

}  // namespace hw::script
