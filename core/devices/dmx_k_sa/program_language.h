#pragma once
#include "core/device/language.h"

namespace hw::dmx_k_sa {

/// Programs of the DMX-K-SA.
const Language& program_language();

}  // namespace hw::dmx_k_sa
