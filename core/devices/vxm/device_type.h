#pragma once
#include "core/device/registry.h"

namespace hw::vxm {

/// The VXM as the registry lists it.
DeviceType device_type();

}  // namespace hw::vxm
