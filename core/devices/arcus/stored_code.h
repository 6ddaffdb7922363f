#pragma once
// What the driver keeps of the code that the controller holds.
#include <bitset>

#include "core/device/snapshot.h"
#include "core/devices/arcus/facts.h"
#include "core/devices/arcus/language/program.h"

namespace hw::arcus {

struct StoredCode {
  std::bitset<max_threads> programs;  ///< that are there
  std::bitset<max_params> sets;       ///< parameters that it may change when it runs
};

[[nodiscard]] StoredCode read_stored_code(const language::Program& code, const Model& model);

}  // namespace hw::arcus
