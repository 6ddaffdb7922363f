#pragma once
#include "core/device/language.h"

namespace hw::pmx_4ex_sa {

/// Programs of the PMX-4EX-SA.
const Language& program_language();

}  // namespace hw::pmx_4ex_sa
