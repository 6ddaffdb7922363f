#pragma once
#include "core/device/registry.h"

namespace hw::vme58 {

DeviceType device_type();

}  // namespace hw::vme58
