#pragma once
// The emulated controller of a rehearsal, made like the one that is known.
#include "core/device/controller_state.h"
#include "core/devices/arcus/emulator_arcus.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

/// `emulator` is fresh from power-up, and nothing moves.
void begin_like(ArcusEmulator& emulator, const ControllerState& state, const Catalog& catalog);
/// What was taken in place of what the state does not tell, for axes that have moved and variables that the
/// program looks at before it has written them.
[[nodiscard]] std::vector<RehearsedAssumption> assumptions(const ControllerState& state,
                                                           const Catalog& catalog, std::uint32_t moved,
                                                           const language::Program& program);

}  // namespace hw::arcus
