#include "core/device/registry.h"

#include "core/devices/vxm/device_type.h"

namespace hw {

std::span<const DeviceType> device_types() {
  static const DeviceType all[] = {
      vxm::device_type(),
  };
  return all;
}

const DeviceType* find_device_type(std::string_view model) {
  for (const DeviceType& type : device_types())
    if (type.model == model) return &type;
  return nullptr;
}

}  // namespace hw
