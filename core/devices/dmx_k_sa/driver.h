#pragma once
#include <memory>

#include "core/device/driver.h"

namespace hw::dmx_k_sa {

/// The driver of the family with this model's forms.
std::unique_ptr<Driver> make_driver(DriverContext context);

}  // namespace hw::dmx_k_sa
