#include "gui/app/version.h"

#include <fmt/core.h>

#include "gui/app/commit.h"

namespace hw::app {

std::string version() {
  constexpr std::string_view commit = HW_COMMIT;
  return commit.empty() ? HW_VERSION : fmt::format("{} ({})", HW_VERSION, commit);
}

}  // namespace hw::app
