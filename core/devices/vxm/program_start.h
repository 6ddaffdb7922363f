#pragma once
// Makes the emulated controller of a rehearsal like the known one: by set-up commands, or in its memory where
// no command exists.
#include <functional>
#include <string>
#include <vector>

#include "core/device/controller_state.h"
#include "core/devices/vxm/emulator_vxm.h"

namespace hw::vxm {

/// `emulator` must be fresh from power-up and on-line. Programs that the text fills are left alone.
void begin_like(VxmEmulator& emulator, const ControllerState& state, const Catalog& catalog,
                const std::function<bool(int)>& text_fills);
/// A finished run.
struct FinishedRun {
  const Box& box;  ///< with its programs
  int slot = 0;    ///< of the first program
  std::function<bool(int)> text_fills;
};
/// The values assumed where the state has none. `moved`: bit per motor.
[[nodiscard]] std::vector<RehearsedAssumption> assumptions(const ControllerState& state,
                                                           const Catalog& catalog, std::uint32_t moved,
                                                           const FinishedRun& ran);

}  // namespace hw::vxm
