#pragma once
// The commands of the PMX-4EX-SA that the DMX-K-SA lacks or spells differently (PMX manual, ch. 9).
#include <span>

#include "core/devices/arcus/emulator_command.h"

namespace hw::pmx_4ex_sa {

[[nodiscard]] std::span<const arcus::Command> commands();

}  // namespace hw::pmx_4ex_sa
