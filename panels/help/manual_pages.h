#pragma once
// The manual of this build: assets/manual, embedded by manual_pages.cmake.
#include <span>
#include <string_view>

namespace hw::panels {

struct ManualPage {
  std::string_view name;  ///< file name without extension: "scripts"
  std::string_view markdown;
};
/// Sorted by name.
std::span<const ManualPage> manual_pages();

}  // namespace hw::panels
