#pragma once
#include "core/devices/arcus/forms.h"

namespace hw::pmx_4ex_sa {

const arcus::Forms& forms();

}  // namespace hw::pmx_4ex_sa
