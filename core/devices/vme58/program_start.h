#pragma once
// The emulated board of a rehearsal, made like the one that is known: by the text that sets it up.
#include <string>

#include "core/device/controller_state.h"
#include "core/devices/vme58/emulator_vme58.h"

namespace hw::vme58 {

/// One short command a line, to be sent to a board fresh from power-up.
[[nodiscard]] std::vector<std::string> text_to_begin_like(const ControllerState& state,
                                                          const Catalog& catalog, const Variant& variant);
/// What no text can do: encoders of step axes, and the lines that a hand on the bench has to hold.
void stand_like(Vme58Emulator& emulator, const ControllerState& state);
/// What was taken in place of what the state does not tell. `moved`: bit per axis.
[[nodiscard]] std::vector<RehearsedAssumption> assumptions(const ControllerState& state,
                                                           const Catalog& catalog, std::uint32_t moved);

}  // namespace hw::vme58
