#pragma once
// The manual of this build: assets/manual, put into the binary by manual_pages.cmake.
#include <span>
#include <string_view>

namespace hw::panels {

struct ManualPage {
  std::string_view name;  ///< of its file: "scripts"
  std::string_view markdown;
};
/// By name.
std::span<const ManualPage> manual_pages();

}  // namespace hw::panels
