#pragma once
// What the console must know of a Velmex VXM to draw it and to talk of it: pure data, from the manual.
#include "core/device/registry.h"

namespace hw::vxm {

/// Option `motors`: 1 or 2 (one controller, 2 unless given), 3 or 4 (a Master with its Slave on the VXM bus).
Result<Catalog> make_catalog(const DeviceOptions& options);

/// Asks for the state and moves nothing, whatever mode the controller is in.
inline constexpr std::string_view probe = "V";
/// One letter B, R, J or b; the letter V before it when echo is on, a prompt that crossed, CR in G mode.
bool recognises(std::string_view reply);

// The parts, each in a file of its own. Used by make_catalog only.
std::vector<ParamInfo> params(int motors);
std::vector<CommandInfo> commands(int motors);

}  // namespace hw::vxm
