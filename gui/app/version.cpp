#include "gui/app/version.h"

#include <string_view>

#include "gui/app/commit.h"

namespace hw::app {

std::string version() {
  constexpr std::string_view commit = HW_COMMIT;
  return commit.empty() ? HW_VERSION : std::string(HW_VERSION) + " (" + std::string(commit) + ")";
}

}  // namespace hw::app
