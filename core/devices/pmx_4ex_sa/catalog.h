#pragma once
// What the console must know of an Arcus PMX-4EX-SA: pure data, from its manual.
#include "core/device/registry.h"

namespace hw::pmx_4ex_sa {

/// Option `id`: the two digits of its device name (RS-485); 00 unless given.
Result<Catalog> make_catalog(const DeviceOptions& options);

/// The commands of ch. 9, with the forms of its table.
std::vector<CommandInfo> command_help();

}  // namespace hw::pmx_4ex_sa
