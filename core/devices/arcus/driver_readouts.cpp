// Readouts, variables, analog inputs, threads. What somebody looks at is asked each round, the rest in turn.
#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/catalog.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {
namespace {

constexpr int variables_per_round = 10, params_per_round = 3;
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

// These ids are no questions: their values stand in the status.
void ArcusDriver::find_readouts_told_by_status() {
  by_status_.assign(catalog_.readouts.size(), false);
  for (std::size_t i = 0; i < by_status_.size(); ++i) {
    const std::string& id = catalog_.readouts[i].id;
    by_status_[i] = id.starts_with("MST") || id == "LATCHIN" || id == "INDEX";
    for (const std::string_view told : forms_.behind_status) by_status_[i] = by_status_[i] || id == told;
  }
}

void ArcusDriver::put_readout(std::string_view id, std::int64_t value) {
  const int index = catalog_.find_readout(id);
  if (index < 0) return;
  draft_.readouts[ix(index)] = value;
  draft_.readouts_known.set(ix(index));
  draft_.readouts_seen_at[ix(index)] = scheduler_.now();
  if (id == "MM") incremental_ = value != 0;
}

Task<Result<>> ArcusDriver::read_readout(int index, Priority priority) {
  const ReadoutInfo& info = catalog_.readouts[ix(index)];
  auto value = co_await talk_.ask_number(info.id, priority);
  if (!value) co_return fail(value.error());
  put_readout(info.id, *value);
  if (info.group == loop && info.axis >= 0 && info.id == fill(forms_, forms_.loop_state, info.axis)) {
    minds_[ix(info.axis)].loop_state = static_cast<int>(*value);
    draft_.axes[info.axis].in_counts = *value != static_cast<int>(LoopState::off);
  }
  co_return Result<>();
}

Task<Result<>> ArcusDriver::read_analog(int number, Priority priority) {
  auto value = co_await talk_.ask_number(fmt::format("AI{}", number), priority);
  if (!value) co_return fail(value.error());
  draft_.analog[ix(number - 1)] = static_cast<std::int32_t>(*value);
  draft_.analog_known |= 1u << (number - 1);
  draft_.analog_seen_at[ix(number - 1)] = scheduler_.now();
  co_return Result<>();
}

Task<Result<>> ArcusDriver::read_variable(int number, Priority priority) {
  auto value = co_await talk_.ask_number(fmt::format("V{}", number), priority);
  if (!value) co_return fail(value.error());
  draft_.variables[ix(number)] = static_cast<std::int32_t>(*value);
  draft_.variables_known.set(ix(number));
  co_return Result<>();
}

Task<Result<>> ArcusDriver::read_watched() {
  for (int i = 0; i < static_cast<int>(catalog_.readouts.size()); ++i) {
    if (by_status_[ix(i)] || !(watched_ >> catalog_.readouts[ix(i)].group & 1)) continue;
    auto read = co_await read_readout(i, Priority::poll);
    if (!read) co_return read;
  }
  if (watched_ >> variable_values & 1)
    for (int i = 0; i < variables_per_round; ++i) {
      auto read = co_await read_variable(next_variable_, Priority::poll);
      if (!read) co_return read;
      next_variable_ = (next_variable_ + 1) % catalog_.variables.count;
    }
  const bool all_analog = (watched_ >> analog_inputs & 1) != 0;
  for (int n = 1; all_analog && n <= model().analog_inputs; ++n) {
    auto read = co_await read_analog(n, Priority::poll);
    if (!read) co_return read;
  }
  co_return Result<>();
}

// At rest, a little of each a round: readouts nobody looks at, one analog input, some parameters: first those
// that are not known, then all again, because programs and terminals change them.
Task<Result<>> ArcusDriver::read_in_turn() {
  const int readouts = static_cast<int>(catalog_.readouts.size());
  for (int tried = 0; tried < readouts; ++tried) {
    const int index = next_readout_;
    next_readout_ = (next_readout_ + 1) % readouts;
    if (by_status_[ix(index)]) continue;
    auto read = co_await read_readout(index, Priority::poll);
    if (!read) co_return read;
    break;
  }
  if (model().analog_inputs > 0) {
    auto read = co_await read_analog(next_analog_ + 1, Priority::poll);
    if (!read) co_return read;
    next_analog_ = (next_analog_ + 1) % model().analog_inputs;
  }
  if (round_ % kept_every == 0) {
    auto read = co_await read_what_power_keeps();
    if (!read) co_return read;
  }
  const int params = static_cast<int>(catalog_.params.size());
  int read_now = 0;
  for (int tried = 0; tried < params && read_now < params_per_round; ++tried) {
    const int index = next_param_;
    next_param_ = (next_param_ + 1) % params;
    if (draft_.params[ix(index)].known) continue;
    auto read = co_await read_param(index, Priority::poll);
    if (!read) co_return read;
    ++read_now;
  }
  if (read_now > 0) co_return Result<>();
  auto read = co_await read_param(next_param_, Priority::poll);
  next_param_ = (next_param_ + 1) % params;
  co_return read;
}

// ---- threads

Task<Result<>> ArcusDriver::read_threads(bool all, Priority priority) {
  bool one_idle_read = false;
  for (int n = 0; n < model().programs; ++n) {
    const int thread = (next_thread_ + n) % model().programs;
    const ThreadState& known = draft_.threads[ix(thread)];
    const bool quiet = known.known && known.run != RunState::running;
    if (quiet && one_idle_read && !all) continue;
    one_idle_read = one_idle_read || quiet;
    auto read = co_await read_thread(thread, priority);
    if (!read) co_return read;
  }
  next_thread_ = (next_thread_ + 1) % model().programs;
  draft_.program.run = RunState::idle;
  draft_.program.owned = false;
  draft_.program.slot = 0;
  for (int n = model().programs - 1; n >= 0; --n) {
    const RunState run = draft_.threads[ix(n)].run;
    if (run == RunState::running || (run == RunState::held && draft_.program.run != RunState::running))
      draft_.program.run = run;
    draft_.program.owned = draft_.program.owned || run == RunState::running || run == RunState::held;
  }
  co_return Result<>();
}

Task<Result<>> ArcusDriver::read_thread(int thread, Priority priority) {
  auto state = co_await talk_.ask_number(fmt::format("SASTAT{}", thread), priority);
  if (!state) co_return fail(state.error());
  const RunState run = run_state(*state);
  const bool nobody_started_it = scheduler_.now() > programs_run_until_ && !called_;
  if (run == RunState::running && nobody_started_it && stood_ && !stood_->program_ran) {
    auto looked = co_await look_at_start(thread, priority);
    if (!looked) co_return looked;
  }
  ThreadState& known = draft_.threads[ix(thread)];
  known.run = run;
  known.known = true;
  if (known.run == RunState::running) {
    draft_.program.ended_by = EndedBy::nothing;
    program_runs();
  }
  if (known.run == RunState::idle) {
    known.line = -1;
    co_return Result<>();
  }
  auto line = co_await talk_.ask_number(fmt::format("SPC{}", thread), priority);
  if (!line) co_return fail(line.error());
  draft_.threads[ix(thread)].line = static_cast<std::int16_t>(*line);
  co_return Result<>();
}

Task<Result<>> ArcusDriver::set_variable(const intent::SetVariable& wish) {
  const VariableFacts& facts = catalog_.variables;
  if (wish.number < 0 || wish.number >= facts.count || wish.value < facts.minimum ||
      wish.value > facts.maximum)
    co_return fail(FaultKind::refused,
                   fmt::format("V{} cannot be set to {}: there are V0 to V{}, of {} to {}.", wish.number,
                               wish.value, facts.count - 1, facts.minimum, facts.maximum),
                   "Nothing was sent.");
  auto set = co_await talk_.command(set_command(fmt::format("V{}", wish.number), wish.value), Priority::intent);
  if (!set) co_return set;
  if (wish.number >= facts.stored_from) unsaved_variables_ = draft_.unsaved_setup = true;
  co_return co_await read_variable(wish.number, Priority::intent);
}

}  // namespace hw::arcus
