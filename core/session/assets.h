#pragma once
// What comes with the program and is read while it runs: manual, examples. Any thread.
#include <filesystem>
#include <string_view>

namespace hw {

/// `name` ("manual", "examples/circle.vme") in the tree that the program was built in, or where it is
/// installed
/// (../share/handwheel, seen from its folder). Empty: in neither.
std::filesystem::path find_asset(std::string_view name);

/// Whether a program in this folder is installed: nothing is to be written beside it.
bool is_installed(const std::filesystem::path& folder_of_program);

/// find_asset(), seen from any folder that a program could stand in.
std::filesystem::path find_asset(const std::filesystem::path& folder_of_program, std::string_view name);

}  // namespace hw
