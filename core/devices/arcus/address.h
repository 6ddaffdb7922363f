#pragma once
// The two-digit address of a device on a line.
#include <string>

#include "core/device/registry.h"
#include "core/devices/arcus/facts.h"

namespace hw::arcus {

/// Option `id` of an address ("07"), or the model's factory address.
Result<int> id_option(const DeviceOptions& options, const Model& model);
/// 7 -> "07".
std::string two_digits(int id);
int factory_id(const Model& model);

}  // namespace hw::arcus
