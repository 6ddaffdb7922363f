// What is read at rest, and the threads.
#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {
namespace {

constexpr int kept_every = 5;  // rounds at rest: about a second

RunState run_state(std::int64_t number) {
  switch (number) {
    case 1: return RunState::running;
    case 2: return RunState::held;
    case 4: return RunState::error;
    default: return RunState::idle;
  }
}

}  // namespace

// A little of each a round: readouts nobody looks at, one analog input, some parameters.
Task<Result<>> ArcusDriver::read_at_rest() {
  auto read = co_await readouts_.read_in_turn();
  if (read && round_ % kept_every == 0) read = co_await setup_.read_what_power_keeps();
  if (!read) co_return read;
  co_return co_await setup_.read_in_turn();
}

// ---- threads

Task<Result<>> ArcusDriver::read_threads(bool all, Priority priority) {
  bool one_idle_read = false;
  for (int n = 0; n < console_.model().programs; ++n) {
    const int thread = (next_thread_ + n) % console_.model().programs;
    const ThreadState& known = console_.draft.threads[ix(thread)];
    const bool quiet = known.known && known.run != RunState::running;
    if (quiet && one_idle_read && !all) continue;
    one_idle_read = one_idle_read || quiet;
    auto read = co_await read_thread(thread, priority);
    if (!read) co_return read;
  }
  next_thread_ = (next_thread_ + 1) % console_.model().programs;
  console_.draft.program.run = RunState::idle;
  console_.draft.program.owned = false;
  console_.draft.program.slot = 0;
  for (int n = console_.model().programs - 1; n >= 0; --n) {
    const RunState run = console_.draft.threads[ix(n)].run;
    if (run == RunState::running ||
        (run == RunState::held && console_.draft.program.run != RunState::running))
      console_.draft.program.run = run;
    console_.draft.program.owned =
        console_.draft.program.owned || run == RunState::running || run == RunState::held;
  }
  co_return Result<>();
}

Task<Result<>> ArcusDriver::read_thread(int thread, Priority priority) {
  auto state = co_await talk_.ask_number(fmt::format("SASTAT{}", thread), priority);
  if (!state) co_return fail(state.error());
  const RunState run = run_state(*state);
  const bool nobody_started_it = !code_.program_may_run() && !code_.was_called();
  if (run == RunState::running && nobody_started_it && watch_.has_looked() && !watch_.program_ran()) {
    auto looked = co_await watch_.look_at_start(thread, priority);
    if (!looked) co_return looked;
  }
  ThreadState& known = console_.draft.threads[ix(thread)];
  known.run = run;
  known.known = true;
  if (known.run == RunState::running) {
    console_.draft.program.ended_by = EndedBy::nothing;
    program_runs();
  }
  if (known.run == RunState::idle) {
    known.line = -1;
    co_return Result<>();
  }
  auto line = co_await talk_.ask_number(fmt::format("SPC{}", thread), priority);
  if (!line) co_return fail(line.error());
  console_.draft.threads[ix(thread)].line = static_cast<std::int16_t>(*line);
  co_return Result<>();
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
