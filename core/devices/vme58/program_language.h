#pragma once
#include "core/device/language.h"

namespace hw::vme58 {

const Language& program_language();

}  // namespace hw::vme58
