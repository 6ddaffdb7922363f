#pragma once
// Files shipped with the program and read at run time: manual, examples. Any thread.
#include <filesystem>
#include <string_view>

namespace hw {

/// Path of `name` ("manual", "examples/circle.vme") in the program's build tree or its installation
/// (../share/handwheel, relative to the program's folder). Empty: in neither.
std::filesystem::path find_asset(std::string_view name);

/// Whether a program in this folder is installed, so that nothing may be written beside it.
bool is_installed(const std::filesystem::path& folder_of_program);

/// find_asset() for a program in the given folder.
std::filesystem::path find_asset(const std::filesystem::path& folder_of_program, std::string_view name);

}  // namespace hw
