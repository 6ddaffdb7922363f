#include "core/device/registry.h"

namespace hw {

std::span<const DeviceType> device_types() { return {}; }

const DeviceType* find_device_type(std::string_view model) {
  for (const DeviceType& type : device_types())
    if (type.model == model) return &type;
  return nullptr;
}

}  // namespace hw
