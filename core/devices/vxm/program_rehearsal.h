#pragma once
// A dry run in virtual time: an emulated VXM at power-up, given the text and started.
#include "core/device/language.h"

namespace hw::vxm {

[[nodiscard]] Result<Rehearsal> rehearse_program(std::string_view text, const RehearseOptions& options);

}  // namespace hw::vxm
