#include "core/devices/pmx_4ex_sa/device_type.h"

#include "core/devices/pmx_4ex_sa/catalog.h"

namespace hw::pmx_4ex_sa {

DeviceType device_type() {
  DeviceType t{};
  t.model = "pmx-4ex-sa";
  t.make_catalog = make_catalog;
  return t;
}

}  // namespace hw::pmx_4ex_sa
