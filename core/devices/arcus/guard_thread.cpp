#include "core/devices/arcus/guard_thread.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::arcus {
namespace {

constexpr std::chrono::milliseconds shortest_silence{500};
constexpr int rounds_of_silence = 3;

std::string variable(int number) { return fmt::format("V{}", number); }

}  // namespace

// ---- the stored guard

void GuardThread::is(JogGuard::State state) { console_.snapshot.jog_guard.state = state; }

// Until the guard has ended, its thread is not shown as a user's program. At any other time another host's
// program may run in it.
void GuardThread::watches(unsigned axes) {
  constexpr Duration until_it_has_ended = std::chrono::seconds(1);
  const bool begins_or_ends = (axes != 0) != at_work();
  watched_ = axes;
  if (!begins_or_ends) return;
  const Instant until = at_work() ? Instant::max() : console_.scheduler.now() + until_it_has_ended;
  threads_.keep_apart(guard_program(console_.model()), until);
}

void GuardThread::is_installed(std::vector<std::string> lines, std::int64_t time_out) {
  lines_ = std::move(lines);
  time_out_ = time_out;
  is(JogGuard::State::installed);
  console_.snapshot.jog_guard.silence = silence();
}

void GuardThread::forget() {
  lines_.clear();
  watches(0);
  is(JogGuard::State::unknown);
}

void GuardThread::goes_out(std::string_view command) {
  if (!command.starts_with("SA") || command.find('=') == command.npos) return;
  lines_.clear();
  is(JogGuard::State::unknown);
}

Result<> GuardThread::may_be_overwritten() const {
  if (!at_work()) return {};
  return fail(FaultKind::refused, "The guard in the program memory is watching a jog.",
              "Nothing was written.", "Release the jog button first.");
}

Result<> GuardThread::allows(std::string_view command) const {
  const auto name = command.substr(0, command.find('='));
  const bool sets = name.size() != command.size();
  const bool takes = command == "STORE" || (sets && (name == "TOC" || name.starts_with("SA")));
  if (!takes || !at_work()) return {};
  return fail(FaultKind::refused,
              "The guard in the controller is watching a jog, and uses TOC and its program.",
              "Nothing was sent.", "Release the jog button first.");
}

// The time-out, chosen by the rate of status rounds on this wire.
std::chrono::milliseconds GuardThread::silence() const {
  const double rounds = console_.snapshot.link.polls_per_second;
  const auto known =
      rounds > 0 ? std::chrono::milliseconds(std::lround(std::ceil(1000 * rounds_of_silence / rounds)))
                 : std::chrono::milliseconds();
  const auto at_rest =
      std::chrono::duration_cast<std::chrono::milliseconds>(rounds_of_silence * period_at_rest);
  return std::max({shortest_silence, known, at_rest});
}

Task<Result<>> GuardThread::set(std::string name, std::int64_t value) {
  co_return co_await conversation_.command(set_command(name, value), Priority::intent);
}

Task<Result<>> GuardThread::may_install() {
  if (console_.snapshot.any_axis_moving())
    co_return fail(FaultKind::refused, "An axis is moving.", "Nothing was written.", "Stop it first.");
  auto read = co_await threads_.read(true, Priority::intent);
  if (!read) co_return read;
  if (auto may = threads_.none_runs(); !may) co_return may;
  auto there = co_await stored_.read();
  if (!there) co_return fail(there.error());
  if (there->empty()) co_return Result<>();
  const auto time_out = read_guard(*there, dialect_, console_.model());
  if (time_out)
    is_installed(std::move(*there), *time_out);
  else
    is(JogGuard::State::no_room);
  co_return fail(FaultKind::refused,
                 time_out ? "The guard is in the program memory already."
                          : "The program memory holds a program, and the guard is written only into an "
                            "empty one.",
                 "Nothing was written.", time_out ? "" : "Save that program and clear it first.");
}

/// Tests whether the controller accepts the time-out, and returns the former one, which a status round
/// restores if a stop or a missed reply ends the test.
Task<Result<std::int64_t>> GuardThread::try_time_out() {
  Conversation::Decode decode = decode_number;
  auto before =
      co_await conversation_.ask_confirmed("TOC", std::move(decode), setup_.param("TOC"), Priority::intent);
  if (!before) co_return before;
  const std::int64_t wanted = silence().count();
  auto set_to = co_await borrowed_.borrow("TOC", wanted, *before);
  if (!set_to) co_return fail(set_to.error());
  auto back = co_await conversation_.ask_number("TOC", Priority::intent);
  auto put_back = co_await borrowed_.give_back();
  if (!back) co_return back;
  if (!put_back) co_return fail(put_back.error());
  if (borrowed_.is_out()) co_return fail(FaultKind::stopped, "A stop came first.", "No program was written.");
  if (*back == wanted) co_return *before;
  co_return fail(FaultKind::controller, fmt::format("TOC was set to {} and reads {}.", wanted, *back),
                 "No program was written.");
}

Task<Result<>> GuardThread::install() {
  if (auto may = co_await may_install(); !may) co_return may;
  const auto time_out = co_await try_time_out();
  if (!time_out) co_return fail(time_out.error());
  std::vector<std::string> lines = guard_lines(dialect_, console_.model(), *time_out);
  code_.forget();
  auto written = co_await stored_.write(lines);
  if (!written) co_return stored_.broken_off(std::move(written.error()));
  console_.snapshot.slots_torn = 0;
  code_.know(read_stored_code(language::decode(lines, dialect_), console_.model()));
  is_installed(std::move(lines), *time_out);
  console_.report(Notice::Kind::info, fmt::format("The guard is now program {} of the controller, and was "
                                                  "compared. It stops a held jog after a silence of {} ms.",
                                                  guard_program(console_.model()), silence().count()));
  co_return Result<>();
}

Task<Result<>> GuardThread::remove() {
  if (auto let = co_await let_go(); !let) co_return let;
  if (auto may = may_be_overwritten(); !may) co_return may;
  auto there = co_await stored_.read();
  if (!there) co_return fail(there.error());
  if (!read_guard(*there, dialect_, console_.model())) {
    is(there->empty() ? JogGuard::State::absent : JogGuard::State::no_room);
    co_return fail(FaultKind::refused, "The program memory does not hold the guard.", "Nothing was written.");
  }
  code_.forget();
  auto cleared = co_await stored_.write({});
  if (!cleared) co_return stored_.broken_off(std::move(cleared.error()));
  console_.snapshot.slots_torn = 0;
  is(JogGuard::State::absent);
  for (const int number : {guard_axes_variable, guard_work_variable})
    if (auto zero = co_await set(variable(number), 0); !zero) co_return zero;
  console_.report(Notice::Kind::info, "The guard was removed, and the program memory is empty again.");
  co_return Result<>();
}

// ---- the work of the guard

// After a stop in between the guard stays at work until the next round.
Task<Result<>> GuardThread::watch(int axis) {
  if (console_.snapshot.jog_guard.state != JogGuard::State::installed) co_return Result<>();
  if (auto has = console_.has_axis(axis); !has) co_return has;
  if (!at_work()) {
    if (auto there = co_await still_there(); !there) co_return there;
    if (auto same = co_await confirm_time_out_unchanged(); !same) co_return same;
  }
  watches(watched_ | 1u << axis);
  auto started = co_await start(watched_);
  if (started || was_kept_back(started.error())) co_return started;
  Fault why = std::move(started.error());
  why.kind = FaultKind::refused;  // no motion command was sent
  why.done = "The guard in the controller did not start, so the jog was not sent.";
  why.advice = "Try again, or remove the guard.";
  co_return fail(std::move(why));
}

/// Checks that the guard is still stored: otherwise a program written since by another host would be started.
Task<Result<>> GuardThread::still_there() {
  const auto stops = std::find_if(lines_.begin(), lines_.end(),
                                  [](const std::string& line) { return line.starts_with("STOP"); });
  auto line = co_await conversation_.ask(fmt::format("SA{}", stops - lines_.begin()), Priority::intent);
  if (!line) {
    line.error().kind = FaultKind::refused;
    line.error().done = "The jog was not sent.";
    co_return fail(line.error());
  }
  if (stops != lines_.end() && *line == *stops) co_return Result<>();
  forget();
  co_return fail(FaultKind::refused, "The program memory no longer holds the guard.", "The jog was not sent.",
                 "See beside the jog pad what stops a jog now, then jog again.");
}

/// Checks that TOC has its former value: otherwise the program would replace the present value when it ends.
Task<Result<>> GuardThread::confirm_time_out_unchanged() {
  Conversation::Decode decode = decode_number;
  auto now = co_await conversation_.ask_confirmed("TOC", std::move(decode), time_out_, Priority::intent);
  if (!now) {
    now.error().kind = FaultKind::refused;
    now.error().done = "The jog was not sent.";
    co_return fail(now.error());
  }
  if (*now == time_out_) co_return Result<>();
  const std::string what = fmt::format(
      "TOC is {}, and the guard in the controller would set it to {} after each jog.", *now, time_out_);
  const std::string how = fmt::format("Set TOC to {}, or remove the guard and install it again.", time_out_);
  co_return fail(FaultKind::refused, what, "The jog was not sent.", how);
}

// V49, the axes, is written first. It has no effect alone, and tells a console that finds it that TOC must be
// restored. TOC comes before the program: the silence counts from then, and earlier silence no longer
// matters.
Task<Result<>> GuardThread::start(unsigned axes) {
  const int program = guard_program(console_.model());
  if (auto sent = co_await set(variable(guard_axes_variable), axes); !sent) co_return sent;
  if (auto sent = co_await set("TOC", silence().count()); !sent) co_return sent;
  if (auto sent = co_await set(fmt::format("SR{}", program), 1); !sent) co_return sent;
  auto runs = co_await conversation_.ask_number(fmt::format("SASTAT{}", program), Priority::intent);
  if (!runs) co_return fail(runs.error());
  if (*runs == 1) co_return Result<>();
  co_return fail(FaultKind::controller, fmt::format("Program {} is not running.", program));
}

// The program ends by itself when no axis is left, and restores TOC; a stop may have ended it before.
Task<Result<>> GuardThread::let_go() {
  unsigned still = 0;
  for (unsigned left = watched_; left != 0; left &= left - 1)
    if (const int axis = std::countr_zero(left); console_.snapshot.axis_moves(axis)) still |= 1u << axis;
  if (still == watched_) co_return Result<>();
  auto sent = co_await set(variable(guard_axes_variable), still);
  if (sent && still == 0) sent = co_await set("TOC", time_out_);
  if (sent) {
    watches(still);
    setup_.was_borrowed("TOC");
  }
  if (!sent && sent.error().kind == FaultKind::stopped) co_return Result<>();  // the next round does it
  co_return sent;
}

// ---- looking for it

Task<Result<>> GuardThread::look() {
  using State = JogGuard::State;
  constexpr int lines_a_round = 4;
  JogGuard& guard = console_.snapshot.jog_guard;
  if (guard.state == State::installed && !at_work()) guard.silence = silence();
  const std::vector<std::string> wanted = guard.state == State::unknown
                                              ? guard_lines(dialect_, console_.model(), time_out_)
                                              : std::vector<std::string>();
  for (int n = 0; guard.state == State::unknown && n < lines_a_round; ++n) {
    std::function<bool(std::string_view)> whatever = [](std::string_view) { return true; };
    auto line =  // only a second refusal counts: the question may have been garbled
        co_await conversation_.ask_for(fmt::format("SA{}", lines_.size()), std::move(whatever),
                                       Priority::poll);
    if (!line && line.error().kind != FaultKind::refused) co_return fail(line.error());
    if (!line) is(State::no_room);  // it has no program memory
    if (guard.state != State::unknown) co_return Result<>();
    const std::size_t at = lines_.size();
    const bool end = at == wanted.size(), sets_time_out = at + 2 == wanted.size();
    if (at == 0 && line->empty()) {
      is(State::absent);
    } else if (end) {
      const auto time_out = line->empty() ? read_guard(lines_, dialect_, console_.model()) : std::nullopt;
      if (time_out) {
        is_installed(std::move(lines_), *time_out);
        co_return co_await take_over();
      }
      is(State::no_room);
    } else if (!sets_time_out && *line != wanted[at]) {
      is(State::no_room);
    } else {
      lines_.push_back(std::move(*line));
    }
  }
  co_return Result<>();
}

/// Takes over from a console that died during a held jog: the next round restores V49 and TOC if all axes
/// stand.
Task<Result<>> GuardThread::take_over() {
  auto axes = co_await conversation_.ask_number(variable(guard_axes_variable), Priority::poll);
  if (!axes) co_return fail(axes.error());
  watches(static_cast<unsigned>(*axes) & ((1u << console_.axes()) - 1));
  co_return Result<>();
}

}  // namespace hw::arcus
