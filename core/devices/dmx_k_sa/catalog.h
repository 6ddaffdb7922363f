#pragma once
// What the console must know of an Arcus DMX-K-SA: pure data, from its manual.
#include "core/device/registry.h"

namespace hw::dmx_k_sa {

/// Option `id`: the two digits of its device name; 01 unless given.
Result<Catalog> make_catalog(const DeviceOptions& options);

/// The commands of ch. 9, with the forms of its table.
std::vector<CommandInfo> command_help();

}  // namespace hw::dmx_k_sa
