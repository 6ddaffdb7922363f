#pragma once
#include "core/devices/arcus/forms.h"

namespace hw::dmx_k_sa {

const arcus::Forms& forms();

}  // namespace hw::dmx_k_sa
