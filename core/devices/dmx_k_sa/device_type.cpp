#include "core/devices/dmx_k_sa/device_type.h"

#include "core/devices/dmx_k_sa/catalog.h"

namespace hw::dmx_k_sa {

DeviceType device_type() {
  DeviceType t{};
  t.model = "dmx-k-sa";
  t.make_catalog = make_catalog;
  return t;
}

}  // namespace hw::dmx_k_sa
