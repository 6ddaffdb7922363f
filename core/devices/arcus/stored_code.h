#pragma once
// What the driver keeps of the code that the controller holds.
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
  bool moves = true;              ///< or starts a program, or hands an axis to the joystick
  std::optional<Duration> rests;  ///< it is over when nothing has moved for so long; none: nobody can tell
};

struct StoredCode {
  std::bitset<max_threads> programs;  ///< that are there
  std::bitset<max_params> sets;       ///< parameters that it may change when it runs
  bool switches_motors = false;       ///< EO: when it runs
  std::array<std::optional<StoredSubroutine>, subroutines> subs;
};

[[nodiscard]] StoredCode read_stored_code(const language::Program& code, const Model& model);

}  // namespace hw::arcus
