#include "core/devices/arcus/threads.h"

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::arcus {
namespace {

RunState run_state(std::int64_t number) {
  switch (number) {
    case 1: return RunState::running;
    case 2: return RunState::held;
    case 4: return RunState::error;
    default: return RunState::idle;
  }
}

}  // namespace

Task<Result<>> Threads::read(bool all, Priority priority) {
  const int first = first_.peek(console_.model().programs);
  bool one_idle_read = false, one_ended = false;
  for (int n = 0; n < console_.model().programs; ++n) {
    const int thread = (first + n) % console_.model().programs;
    const ThreadState& known = console_.snapshot.threads[ix(thread)];
    const bool ran = known.known && known.run == RunState::running;
    const bool quiet = known.known && !ran;
    if (quiet && one_idle_read && !all) continue;
    one_idle_read = one_idle_read || quiet;
    auto read = co_await read_one(thread, priority);
    if (!read) co_return read;
    one_ended = one_ended || (ran && known.run == RunState::idle);
  }
  first_.next(console_.model().programs);
  // The last statement of the ended program may have started a thread that was read before it. Without
  // another reading, nothing would seem to run.
  if (one_ended && !all) co_return co_await this->read(true, priority);
  show_program();
  co_return Result<>();
}

void Threads::show_program() const {
  console_.snapshot.program.run = RunState::idle;
  console_.snapshot.program.owned = false;
  console_.snapshot.program.slot = 0;
  for (int n = console_.model().programs - 1; n >= 0; --n) {
    const RunState run = console_.snapshot.threads[ix(n)].run;
    if (run == RunState::running ||
        (run == RunState::held && console_.snapshot.program.run != RunState::running))
      console_.snapshot.program.run = run;
    console_.snapshot.program.owned =
        console_.snapshot.program.owned || run == RunState::running || run == RunState::held;
  }
}

Task<Result<>> Threads::read_one(int thread, Priority priority) {
  if (is_apart(thread)) {
    console_.snapshot.threads[ix(thread)] = ThreadState{RunState::idle, true};
    co_return Result<>();
  }
  auto state = co_await conversation_.ask_number(fmt::format("SASTAT{}", thread), priority);
  if (!state) co_return fail(state.error());
  const RunState run = run_state(*state);
  const bool unexplained_start = !code_.program_may_run() && !code_.was_called();
  if (run == RunState::running && unexplained_start && watch_.has_looked() && !watch_.program_ran()) {
    auto looked = co_await watch_.look_at_start(thread, priority);
    if (!looked) co_return looked;
  }
  ThreadState& known = console_.snapshot.threads[ix(thread)];
  known.run = run;
  known.known = true;
  if (known.run == RunState::running) {
    console_.snapshot.program.ended_by = EndedBy::nothing;
    program_runs();
  }
  if (known.run == RunState::idle) {
    known.line = -1;
    co_return Result<>();
  }
  auto line = co_await conversation_.ask_number(fmt::format("SPC{}", thread), priority);
  if (!line) co_return fail(line.error());
  console_.snapshot.threads[ix(thread)].line = static_cast<std::int16_t>(*line);
  co_return Result<>();
}

// ---- commands to threads

void Threads::may_start(std::string_view command) {
  if (is_apart(thread_named_in(command).value_or(-1))) return;
  if (command.starts_with("SR") && !ends_program(command)) {
    console_.snapshot.variables_known.reset();  // the program may be over before its state is read
    program_runs();
  }
  if (command.starts_with("GS")) program_runs(code_.longest_run(command));
}

void Threads::command_sent(std::string_view command) {
  const auto n = thread_named_in(command);
  if (!n || *n < 0 || *n >= console_.model().programs || is_apart(*n)) return;
  console_.snapshot.threads[ix(*n)].known = false;
  if (!ends_program(command))
    console_.snapshot.threads[ix(*n)].run = RunState::running;  // a stop ends it first
}

void Threads::program_runs(Duration at_most) {
  setup_.code_may_set();
  code_.program_runs(at_most);
}

// ---- what may run

bool Threads::may_run(int thread) const {
  const ThreadState& state = console_.snapshot.threads[ix(thread)];
  return state.known && state.run != RunState::idle && state.run != RunState::error;
}

bool Threads::any_may_run() const {
  for (int n = 0; n < console_.model().programs; ++n)
    if (may_run(n)) return true;
  return false;
}

tl::unexpected<Fault> Threads::no_program(int number, std::string done) const {
  return fail(
      FaultKind::refused,
      fmt::format("There is no program {}: programs are 0 to {}.", number, console_.model().programs - 1),
      std::move(done));
}

std::string Threads::error_sentence(int program, int line) {
  return fmt::format("Program {} stopped with an error at line {} of its stored code.", program, line);
}

Result<> Threads::none_runs() const {
  for (int n = 0; n < console_.model().programs; ++n) {
    const RunState run = console_.snapshot.threads[ix(n)].run;
    if (run == RunState::running || run == RunState::held)
      return fail(FaultKind::refused,
                  fmt::format("Program {} is running, and all programs share the stored code.", n),
                  "Nothing was written.", "Stop it first.");
  }
  return {};
}

}  // namespace hw::arcus
