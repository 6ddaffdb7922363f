#pragma once
// Makes the shell completions from the tables of the command line.
#include <string>

namespace hw::app {

std::string completion_for_bash();
std::string completion_for_zsh();
std::string completion_for_fish();

}  // namespace hw::app
