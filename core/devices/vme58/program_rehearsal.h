#pragma once
#include "core/device/language.h"

namespace hw::vme58 {

Result<Rehearsal> rehearse_program(std::string_view text, const RehearseOptions& options);

}  // namespace hw::vme58
