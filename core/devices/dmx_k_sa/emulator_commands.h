#pragma once
// The commands of the DMX-K-SA that the PMX-4EX-SA lacks or spells differently (DMX manual, ch. 9).
#include <span>

#include "core/devices/arcus/emulator_command.h"

namespace hw::dmx_k_sa {

[[nodiscard]] std::span<const arcus::Command> commands();

}  // namespace hw::dmx_k_sa
