#include "core/session/assets.h"

#include <system_error>

namespace hw {
namespace fs = std::filesystem;
namespace {

constexpr const char* built = "../assets";
constexpr const char* installed = "../share/handwheel";

}  // namespace

fs::path find_asset(const fs::path& folder_of_program, std::string_view name) {
  for (const char* place : {built, installed}) {
    std::error_code error;
    const fs::path asset = (folder_of_program / place / name).lexically_normal();
    if (fs::exists(asset, error)) return asset;
  }
  return {};
}

fs::path find_asset(std::string_view name) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : find_asset(program.parent_path(), name);
}

bool is_installed(const fs::path& folder_of_program) {
  std::error_code error;
  return !fs::exists(folder_of_program / built, error) && fs::exists(folder_of_program / installed, error);
}

}  // namespace hw
