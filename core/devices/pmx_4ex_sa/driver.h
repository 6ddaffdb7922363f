#pragma once
#include <memory>

#include "core/device/driver.h"

namespace hw::pmx_4ex_sa {

/// The driver of the family with this model's forms.
std::unique_ptr<Driver> make_driver(DriverContext context);

}  // namespace hw::pmx_4ex_sa
