#pragma once
// The emulated controller of a rehearsal, made like the one that is known: by the commands that set it up,
// and what has none, in its memory.
#include <functional>
#include <string>
#include <vector>

#include "core/device/controller_state.h"
#include "core/devices/vxm/emulator_vxm.h"

namespace hw::vxm {

/// `emulator` is fresh from power-up and on-line. Programs that `text_fills` has by their number are left
/// alone.
void begin_like(VxmEmulator& emulator, const ControllerState& state, const Catalog& catalog,
                const std::function<bool(int)>& text_fills);
/// What has run.
struct Ran {
  const Box& box;  ///< with the programs that it held
  int slot = 0;    ///< of the first
  std::function<bool(int)> text_fills;
};
/// What was taken in place of what the state does not tell. `moved`: bit per motor.
[[nodiscard]] std::vector<RehearsedAssumption> assumptions(const ControllerState& state,
                                                           const Catalog& catalog, std::uint32_t moved,
                                                           const Ran& ran);

}  // namespace hw::vxm
