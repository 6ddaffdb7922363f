#pragma once
// Program texts of the VXM: colours, costs, problems in sentences, and a dry run.
#include "core/device/language.h"

namespace hw::vxm {

[[nodiscard]] const Language& program_language();

}  // namespace hw::vxm
