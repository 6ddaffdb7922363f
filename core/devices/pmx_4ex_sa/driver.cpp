#include "core/devices/pmx_4ex_sa/driver.h"

#include "core/devices/arcus/driver.h"
#include "core/devices/pmx_4ex_sa/forms.h"

namespace hw::pmx_4ex_sa {

std::unique_ptr<Driver> make_driver(DriverContext context) {
  return std::make_unique<arcus::ArcusDriver>(std::move(context), forms(), arcus::language::pmx_4ex_sa());
}

}  // namespace hw::pmx_4ex_sa
