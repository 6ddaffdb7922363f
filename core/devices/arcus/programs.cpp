#include "core/devices/arcus/programs.h"

#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/guard_text.h"
#include "core/devices/arcus/language/compiler.h"
#include "core/devices/arcus/language/decompiler.h"

namespace hw::arcus {
namespace {

constexpr int thread_run = 1, thread_pause = 2, thread_continue = 3;

std::string foreign_lines(const std::vector<language::BadLine>& bad, const std::vector<std::string>& lines) {
  const bool one = bad.size() == 1;
  const int first = bad.front().line;
  return fmt::format(
      "{} line{} of the stored code cannot be read here: {}line {} ({}). {} in the text as {}. Another "
      "program may have written the code. If you send the text back unchanged, the controller loses {}.",
      bad.size(), one ? "" : "s", one ? "" : "the first is ", first, lines[ix(first)],
      one ? "It appears" : "They appear", one ? "a comment" : "comments", one ? "it" : "them");
}

std::string stored_lines(int count, int written) {
  const std::string what = written == 0   ? "nothing had to be written"
                           : written == 1 ? "1 was written and compared"
                                          : fmt::format("{} were written and compared", written);
  return fmt::format("{} of {} lines {} stored: {}. {} when the power goes off.", count, program_lines,
                     count == 1 ? "is" : "are", what, count == 1 ? "It stays" : "They stay");
}

}  // namespace

Task<Result<>> Programs::perform(IntentBody body) {
  using namespace intent;
  if (const auto* i = std::get_if<LoadProgram>(&body)) co_return co_await load(i->slot, i->text);
  if (const auto* i = std::get_if<UploadProgram>(&body)) co_return co_await upload(i->slot);
  if (std::holds_alternative<ClearProgram>(body)) {
    auto read = co_await threads_.read(true, Priority::intent);
    if (!read) co_return read;
    if (auto may = threads_.none_runs(); !may) co_return may;
    code_.forget();
    auto cleared = co_await stored_.write({});
    if (!cleared) co_return stored_.broken_off(std::move(cleared.error()));
    console_.snapshot.slots_torn = 0;
    co_return Result<>();
  }
  if (std::holds_alternative<SelectProgram>(body)) co_return Result<>();
  if (const auto* i = std::get_if<RunProgram>(&body)) co_return co_await run(i->slot);
  if (const auto* i = std::get_if<Pause>(&body)) co_return co_await control_all(i->thread, thread_pause);
  if (const auto* i = std::get_if<Resume>(&body)) co_return co_await control_all(i->thread, thread_continue);
  co_return fail(FaultKind::refused, fmt::format("A {} has no command for this.", console_.model().title),
                 "Nothing was sent.");
}

// ---- threads

Task<Result<>> Programs::control(int thread, int what) {
  if (thread < 0 || thread >= console_.model().programs)
    co_return threads_.no_program(thread, "Nothing was sent.");
  const std::string text = fmt::format("SR{}={}", thread, what);
  if (what == thread_run) console_.snapshot.program.ended_by = EndedBy::nothing;
  auto done = co_await conversation_.command(text, Priority::intent);
  if (!done) {
    Fault fault = co_await status_.after_doubt(std::move(done.error()), text);
    co_return fail(std::move(fault));
  }
  if (what == thread_run) console_.snapshot.program.started_at = console_.scheduler.now();
  auto read = co_await threads_.read(false, Priority::intent);
  if (!read) co_return read;
  const RunState now = console_.snapshot.threads[ix(thread)].run;
  if (what == thread_run && now == RunState::error) {
    has_run(thread);
    co_return fail(FaultKind::controller,
                   Threads::error_sentence(thread, console_.snapshot.threads[ix(thread)].line), {},
                   "Check the program, and whether an axis has an error.");
  }
  co_return Result<>();
}

// The program ended before its state was read: notices of ends need to see that it ran.
void Programs::has_run(int thread) {
  ThreadState& state = console_.snapshot.threads[ix(thread)];
  const RunState over = std::exchange(state.run, RunState::running);
  console_.changed();
  state.run = over;
}

// SR is answered with OK whether or not the program exists (decision AMB-115). A running program exists; one
// that does not run may have ended already, so the stored code is checked.
Task<Result<>> Programs::run(int program) {
  auto started = co_await control(program, thread_run);
  if (!started || console_.snapshot.threads[ix(program)].run != RunState::idle) co_return started;
  if (code_.known() && code_.known()->programs[ix(program)]) {
    has_run(program);
    co_return started;
  }
  auto there = co_await stored_.read();
  if (!there) co_return fail(there.error());
  note_stored(*there);
  if (!code_.known() || code_.known()->programs[ix(program)]) {
    has_run(program);
    co_return started;
  }
  co_return fail(FaultKind::refused, fmt::format("There is no program {0} in the stored code.", program),
                 "Nothing was started.",
                 program == 0 ? "Load one first." : fmt::format("Its text begins with PRG {}.", program));
}

// Notes which programs the stored code has; unknown for code of another compiler.
void Programs::note_stored(const std::vector<std::string>& lines) {
  code_.forget();
  const language::Program code = language::decode(lines, dialect_);
  if (code.bad_lines.empty()) code_.know(read_stored_code(code, console_.model()));
}

// All running or all held programs; or only `thread`, if it is one of them.
Task<Result<>> Programs::control_all(int thread, int what) {
  if (thread >= console_.model().programs) co_return co_await control(thread, what);  // control() refuses it
  auto read = co_await threads_.read(true, Priority::intent);
  if (!read) co_return read;
  const bool pauses = what == thread_pause;
  bool any = false;
  for (int n = 0; n < console_.model().programs; ++n) {
    const bool concerned =
        console_.snapshot.threads[ix(n)].run == (pauses ? RunState::running : RunState::held);
    if (!concerned || (thread >= 0 && n != thread)) continue;
    any = true;
    auto done = co_await control(n, what);
    if (!done) co_return done;
  }
  if (any) co_return Result<>();
  const std::string which = thread < 0 ? "No program" : fmt::format("Program {}", thread);
  const char* not_so =
      thread < 0 ? (pauses ? "is running" : "is held") : (pauses ? "is not running" : "is not held");
  co_return fail(FaultKind::refused, fmt::format("{} {}.", which, not_so), "Nothing was sent.");
}

// The stored code is one text for all programs, and a new one replaces all of it. A text sent as a further
// program must be that program, and must not remove others.
Task<Result<>> Programs::may_be_program(int program, const language::Program& code) {
  if (program >= console_.model().programs) co_return threads_.no_program(program, "Nothing was written.");
  if (!code.programs[ix(program)])
    co_return fail(FaultKind::refused,
                   fmt::format("This text is {}; begin it with PRG {}.",
                               code.programs[0] ? "program 0" : "another program", program),
                   "Nothing was written.");
  auto there = co_await stored_.read();
  if (!there) co_return fail(there.error());
  note_stored(*there);
  const bool guard = read_guard(*there, dialect_, console_.model()).has_value();  // any text may replace it
  for (int n = 0; code_.known() && !guard && n < console_.model().programs; ++n)
    if (code_.known()->programs[ix(n)] && !code.programs[ix(n)])
      co_return fail(FaultKind::refused,
                     fmt::format("The controller holds program {} too, and a text replaces all programs.", n),
                     "Nothing was written.", fmt::format("Put PRG {} and PRG {} into one text.", n, program));
  co_return Result<>();
}

Task<Result<>> Programs::load(int program, std::string text) {
  auto read = co_await threads_.read(true, Priority::intent);  // others may have started one
  if (!read) co_return read;
  if (auto may = threads_.none_runs(); !may) co_return may;
  const language::Compilation made = language::compile(text, dialect_);
  for (const Problem& p : made.problems)
    if (p.error)
      co_return fail(FaultKind::refused,
                     fmt::format("The program has an error in line {}: {}", p.line + 1, p.sentence),
                     "Nothing was written.");
  if (program > 0) {
    auto may = co_await may_be_program(program, made.program);
    if (!may) co_return may;
  }
  const std::vector<std::string> lines = made.lines;
  code_.forget();
  auto written = co_await stored_.write(lines);
  if (!written) co_return stored_.broken_off(std::move(written.error()));
  console_.snapshot.slots_torn = 0;
  note_stored(lines);
  console_.report(Notice::Kind::info, stored_lines(static_cast<int>(lines.size()), *written));
  co_return Result<>();
}

// Number 0 reads the whole text, a further number that program alone.
Task<Result<>> Programs::upload(int program) {
  if (program >= console_.model().programs) co_return threads_.no_program(program, "Nothing was sent.");
  auto lines = co_await stored_.read();
  if (!lines) co_return fail(lines.error());
  note_stored(*lines);
  console_.snapshot.slot_bytes_used[0] = static_cast<std::int16_t>(lines->size());
  const language::Decompiled source = language::decompile(*lines, dialect_);
  const bool whole = program <= 0;
  Notice notice(Notice::Kind::program, console_.scheduler.now(),
                whole ? source.text : language::program_alone(*lines, dialect_, program));
  notice.slot = whole ? 0 : program;
  notice.whole = source.bad_lines.empty();
  console_.notify(std::move(notice));
  if (!source.bad_lines.empty())
    console_.report(Notice::Kind::warning, foreign_lines(source.bad_lines, *lines));
  co_return Result<>();
}

}  // namespace hw::arcus
