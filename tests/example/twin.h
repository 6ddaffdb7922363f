#pragma once
// The parts of the example, as core/devices/registry.cpp would see those of a listed controller.
#include "core/device/registry.h"

namespace hw::twin {

Result<Catalog> make_catalog(const DeviceOptions& options);
std::unique_ptr<Driver> make_driver(DriverContext context);
Result<std::unique_ptr<Emulator>> make_emulator(const DeviceOptions& options);
DeviceType device_type();

}  // namespace hw::twin
