#pragma once
// The description of a Velmex VXM for drawing and for messages: pure data, from the manual.
#include "core/device/registry.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {

/// Option `motors`: 1 or 2 (one controller, 2 unless given), 3 or 4 (a Master with its Slave on the VXM bus).
Result<Catalog> make_catalog(const DeviceOptions& options);

/// Asks for the state. Moves nothing in any mode.
inline constexpr std::string_view probe = "V";
/// B, R, J or b, perhaps with an echoed V or a crossing prompt before it, and a CR in G mode.
bool recognises(std::string_view reply);

inline constexpr AccelerationUnit acceleration_unit{"x 1000 steps/s²", "as A of the motor", min_accel,
                                                    max_accel};

// Parts of the catalog, one file each. Used by make_catalog only.
std::vector<ParamInfo> params(int motors);
std::vector<CommandInfo> commands(int motors);

/// The help of a command without a number or motor of its own: "U4", "R", "lst". Empty: there is none.
std::string_view help_of(std::string_view form);

}  // namespace hw::vxm
