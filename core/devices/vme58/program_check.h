#pragma once
// Checks a command string before it is sent.
#include <string_view>

#include "core/device/language.h"

namespace hw::vme58 {

ProgramReport check_program(std::string_view text);

}  // namespace hw::vme58
