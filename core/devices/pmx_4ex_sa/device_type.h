#pragma once
#include "core/device/registry.h"

namespace hw::pmx_4ex_sa {

DeviceType device_type();

}  // namespace hw::pmx_4ex_sa
