#pragma once
#include "core/device/registry.h"

namespace hw::dmx_k_sa {

DeviceType device_type();

}  // namespace hw::dmx_k_sa
