#include "core/devices/dmx_k_sa/driver.h"

#include "core/devices/arcus/driver.h"
#include "core/devices/dmx_k_sa/forms.h"

namespace hw::dmx_k_sa {

std::unique_ptr<Driver> make_driver(DriverContext context) {
  return std::make_unique<arcus::ArcusDriver>(std::move(context), forms(), arcus::language::dmx_k_sa());
}

}  // namespace hw::dmx_k_sa
