// What is read at rest; variables.
#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {
namespace {

constexpr int kept_every = 5;  // rounds at rest: about a second

}  // namespace

// A little of each a round: readouts nobody looks at, one analog input, some parameters.
Task<Result<>> ArcusDriver::read_at_rest() {
  auto read = co_await readouts_.read_in_turn();
  if (read && round_ % kept_every == 0) read = co_await setup_.read_what_power_keeps();
  if (!read) co_return read;
  co_return co_await setup_.read_in_turn();
}

Task<Result<>> ArcusDriver::set_variable(const intent::SetVariable& wish) {
  const VariableFacts& facts = console_.catalog.variables;
  if (wish.number < 0 || wish.number >= facts.count || wish.value < facts.minimum ||
      wish.value > facts.maximum)
    co_return fail(FaultKind::refused,
                   fmt::format("V{} cannot be set to {}: there are V0 to V{}, of {} to {}.", wish.number,
                               wish.value, facts.count - 1, facts.minimum, facts.maximum),
                   "Nothing was sent.");
  auto set =
      co_await talk_.command(set_command(fmt::format("V{}", wish.number), wish.value), Priority::intent);
  if (!set) co_return set;
  if (wish.number >= facts.stored_from) setup_.variable_is_unsaved();
  co_return co_await readouts_.read_variable(wish.number, Priority::intent);
}

}  // namespace hw::arcus
