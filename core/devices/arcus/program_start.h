#pragma once
// Gives the emulated controller of a rehearsal the known state of the real one.
#include "core/device/controller_state.h"
#include "core/devices/arcus/emulator_arcus.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

/// `emulator` is fresh from power-up, and nothing moves.
void begin_like(ArcusEmulator& emulator, const ControllerState& state, const Catalog& catalog);
/// Values assumed where the state is unknown, for axes that have moved and variables that the program reads
/// before writing them.
[[nodiscard]] std::vector<RehearsedAssumption> assumptions(const ControllerState& state,
                                                           const Catalog& catalog, std::uint32_t moved,
                                                           const language::Program& program);

}  // namespace hw::arcus
