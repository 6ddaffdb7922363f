#pragma once
// Sets up the emulated board of a rehearsal like the real one, by command text.
#include <string>

#include "core/device/controller_state.h"
#include "core/devices/vme58/emulator_vme58.h"

namespace hw::vme58 {

/// One short command per line, for a board fresh from power-up.
[[nodiscard]] std::vector<std::string> text_to_begin_like(const ControllerState& state,
                                                          const Catalog& catalog, const Variant& variant);
/// Sets what no text can set: encoders of step axes, and lines held by the bench.
void stand_like(Vme58Emulator& emulator, const ControllerState& state);
/// Assumptions made where the state is unknown. `moved`: bit per axis.
[[nodiscard]] std::vector<RehearsedAssumption> assumptions(const ControllerState& state,
                                                           const Catalog& catalog, std::uint32_t moved);

}  // namespace hw::vme58
