#include "core/device/registry.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "core/devices/dmx_k_sa/device_type.h"
#include "core/devices/pmx_4ex_sa/device_type.h"
#include "core/devices/vme58/device_type.h"
#include "core/devices/vxm/device_type.h"

namespace hw {
namespace {

std::vector<DeviceType>& listed_types() {
  static std::vector<DeviceType> all = {
      vxm::device_type(),
      pmx_4ex_sa::device_type(),
      dmx_k_sa::device_type(),
      vme58::device_type(),
  };
  return all;
}

}  // namespace

std::span<const DeviceType> device_types() { return listed_types(); }
void add_device_type(const DeviceType& type) { listed_types().push_back(type); }

const DeviceType* find_device_type(std::string_view model) {
  for (const DeviceType& type : device_types())
    if (std::equal(type.model.begin(), type.model.end(), model.begin(), model.end(),
                   [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); }))
      return &type;
  return nullptr;
}

}  // namespace hw
