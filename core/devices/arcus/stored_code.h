#pragma once
// Facts that the driver remembers about the controller's stored code.
#include <array>
#include <bitset>
#include <optional>

#include "core/device/snapshot.h"
#include "core/devices/arcus/facts.h"
#include "core/devices/arcus/language/program.h"
#include "core/time/clock.h"

namespace hw::arcus {

/// A subroutine that the host may call.
struct StoredSubroutine {
  bool moves = true;              ///< it moves an axis, starts a program, or hands an axis to the joystick
  std::optional<Duration> rests;  ///< ended once nothing has moved for this long; none: unknown
};

struct StoredCode {
  std::bitset<max_threads> programs;  ///< present
  std::bitset<max_params> sets;       ///< parameters that it may change
  bool switches_motors = false;       ///< by EO
  std::array<std::optional<StoredSubroutine>, subroutines> subs;
};

[[nodiscard]] StoredCode read_stored_code(const language::Program& code, const Model& model);

}  // namespace hw::arcus
