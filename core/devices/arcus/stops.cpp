#include "core/devices/arcus/stops.h"

#include <bit>
#include <bitset>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/axis_motion.h"

namespace hw::arcus {
namespace {

constexpr Duration next_move_of_a_program = std::chrono::seconds(1);
constexpr int stop_attempts = 3;
constexpr Duration until_confirmed = Millis(200);

Fault joystick_not_read(bool switched_off) {
  return Fault(FaultKind::garbled, "The controller did not report which axes follow the joystick.",
               switched_off ? "STOP was sent, and the joystick was switched off for all axes."
                            : "STOP was sent; the joystick was left as it is.",
               switched_off ? "" : "Stop all axes if this axis still moves.");
}

}  // namespace

Task<Result<>> Stops::stop(const StopOrder& order) {
  const Instant began = console_.scheduler.now();
  auto sent = co_await send(order, until_next_of_stop);
  const bool received = conversation_.is_open() && conversation_.station()->received_at() >= began;
  const bool may_ask = received && !order.in_haste;
  if (!sent && may_ask &&
      worth_another_try(sent.error())) {  // on a clean line the replies belong to the stop
    const bool clean = co_await conversation_.clean_line(Priority::stop);
    if (clean) sent = co_await send(order, until_confirmed);
  }
  co_return sent;
}

Task<Result<>> Stops::send(const StopOrder& order, Duration patience) {
  using What = StopOrder::What;
  if (order.what == What::broadcast) co_return co_await stop_line(order.at_once);
  if (order.what == What::program) co_return co_await halt_program(order.thread, patience);
  co_return co_await stop_axes(order, patience);
}

// A stop for all devices of the line, in the same words as the stops of the single devices, which follow: on
// a silent line those wait for one another.
Task<Result<>> Stops::stop_line(bool at_once) {
  if (console_.model().broadcast < 0) co_return Result<>();
  const std::string word = at_once ? "ABORT" : "STOP";
  auto all = co_await conversation_.broadcast(word, Priority::stop);
  for (int n = 0; all && n < console_.model().programs; ++n)
    all = co_await conversation_.broadcast(fmt::format("SR{}=0", n), Priority::stop);
  if (all) all = co_await conversation_.broadcast(word, Priority::stop);
  co_return all;
}

// The stop of a jog stops only the axes that the jog moves: programs, and axes that they move, continue. The
// joystick is checked after all stops were sent; if they were not understood, or another stop waits, it is
// checked next time.
Task<Result<>> Stops::stop_axes(const StopOrder& order, Duration patience) {
  list_.end();
  const std::string_view form = order.at_once ? console_.forms.abort : console_.forms.stop;
  const int axis = console_.axes() == 1 ? -1 : order.axis;
  const bool motion_only = order.what == StopOrder::What::jog;
  const std::string word =
      axis < 0 ? std::string(form.substr(0, form.find('a'))) : fill(console_.forms, form, axis);
  motions_.stopping(axis, order.at_once);
  Result<> sent;
  if (axis < 0 && !motion_only)
    sent = co_await stop_all(word, patience);
  else
    sent = co_await conversation_.command(word, Priority::stop, patience);
  const bool understood = sent || sent.error().kind == FaultKind::refused;
  if (motion_only || !understood) co_return sent;
  if (order.in_haste)
    co_return fail(FaultKind::stopped, "Another stop is waiting.", "The joystick was not checked.");
  auto released = co_await release_joystick(axis, word);
  co_return sent ? released : sent;
}

// Running programs are stopped first, then the motion they began meanwhile; then programs that were idle when
// last read, which a program, another host or a power-up may have started. An unconfirmed command does not
// hold up the next.
Task<Result<>> Stops::stop_all(std::string word, Duration patience) {
  halting_ = true;
  std::bitset<max_threads> running;
  for (int n = 0; n < console_.model().programs; ++n) {
    const RunState last = console_.snapshot.threads[ix(n)].run;  // even if no longer known
    running.set(ix(n), last == RunState::running || last == RunState::held);
  }
  Result<> all = co_await conversation_.command(word, Priority::stop, patience);
  const auto note = [&all](Result<> next) {
    if (all && !next) all = std::move(next);
  };
  for (const bool those_that_run : {true, false}) {
    bool any_halted = false;
    for (int n = 0; n < console_.model().programs; ++n) {
      if (running.test(ix(n)) != those_that_run) continue;
      any_halted = true;
      auto halted = co_await halt_thread(n, patience);
      note(std::move(halted));
    }
    if (!any_halted) continue;
    auto sent = co_await conversation_.command(word, Priority::stop, patience);
    note(std::move(sent));
  }
  co_return all;
}

Task<Result<>> Stops::halt_thread(int thread, Duration patience) {
  std::string text = fmt::format("SR{}=0", thread);
  co_return co_await conversation_.command(std::move(text), Priority::stop, patience);
}

// The program ends; its motion continues.
Task<Result<>> Stops::halt_program(int thread, Duration patience) {
  if (thread >= console_.model().programs) co_return threads_.no_program(thread, "Nothing was sent.");
  halting_ = true;
  Result<> all;
  for (int n = 0; n < console_.model().programs; ++n) {
    if (thread >= 0 && n != thread) continue;
    auto halted = co_await halt_thread(n, patience);
    if (all && !halted) all = std::move(halted);
  }
  co_return all;
}

// The axes would continue to follow the stick. JE is read each time: programs, other hosts and a power-up
// switch it on.
Task<Result<>> Stops::release_joystick(int axis, std::string stop) {
  if (!console_.forms.joystick) co_return Result<>();
  const int index = console_.catalog.find_param("JE");
  const auto mask = co_await conversation_.ask_number("JE", Priority::stop);
  if (!mask && (mask.error().kind == FaultKind::lost || mask.error().kind == FaultKind::stopped))
    co_return fail(mask.error());
  const std::int64_t kept = axis < 0 || !mask ? 0 : *mask & ~(std::int64_t{1} << axis);
  if (mask && kept == *mask) co_return Result<>();
  if (!mask && axis >= 0) {
    console_.snapshot.params[ix(index)].known = false;
    co_return fail(joystick_not_read(false));
  }
  const auto set = co_await conversation_.command(set_command("JE", kept), Priority::stop);
  setup_.changed(index);
  auto sent = co_await conversation_.command(stop, Priority::stop);
  if (!set) co_return set;
  if (!mask) co_return fail(joystick_not_read(true));
  console_.snapshot.params[ix(index)].value = kept;
  console_.snapshot.params[ix(index)].known = true;
  console_.report(Notice::Kind::info, "The joystick was switched off by the stop.");
  co_return sent;
}

// Replies to the command cut short and to the last question may still be on the line: the stop waits for them
// and is sent twice. For several axes all are stopped, since each command would collide with the reply to the
// one before.
LastWill Stops::last_will(unsigned axes) const {
  const std::string_view form = console_.forms.stop;
  const bool one = console_.axes() > 1 && std::has_single_bit(axes);
  const std::string word =
      one ? fill(console_.forms, form, std::countr_zero(axes)) : std::string(form.substr(0, form.find('a')));
  const std::string stop = frame(conversation_.framing(), console_.catalog.address, word);
  if (conversation_.framing() == Framing::message) return {{Millis(0), stop}, {Millis(100), stop}};
  return {{Millis(0), std::string(cut_off)}, {Millis(50), stop}, {Millis(150), stop}};
}

// ---- progress

Task<Result<>> Stops::look() {
  auto seen = co_await status_.read(Priority::stop);
  if (!seen) co_return seen;
  if (halting_) co_return co_await threads_.read(true, Priority::stop);
  co_return Result<>();
}

StopProgress Stops::progress(const StopOrder& order) {
  if (order.what == StopOrder::What::words) return StopProgress::stands();  // the words were sent
  const bool all = order.axis < 0 || console_.axes() == 1;
  if (order.what != StopOrder::What::jog && all) {
    if (auto programs = programs_end(order); programs.now != StopProgress::Now::stands) return programs;
    halting_ = false;
  }
  if (order.what == StopOrder::What::program) return StopProgress::stands();
  bool turns = false;
  for (int i = 0; i < console_.axes(); ++i) turns = turns || ((all || i == order.axis) && motions_.runs(i));
  if (order.what == StopOrder::What::everything && all && code_.subroutine_may_run()) {
    StopProgress progress = code_.outlast(order, turns);
    using Now = StopProgress::Now;
    if (progress.now == Now::stands || progress.now == Now::failed) motions_.stands(-1);
    return progress;
  }
  if (turns && !all && threads_.any_may_run() &&
      console_.scheduler.now() - order.sent_at > next_move_of_a_program) {
    console_.report(Notice::Kind::warning,
                    fmt::format("Stop all axes to end the program too: it moves {} again.",
                                console_.axis_name(order.axis)));
    motions_.stands(order.axis);
    return StopProgress::stands();
  }
  StopProgress progress = progress_of_stop(turns, console_.scheduler.now() - order.sent_at);
  if (progress.now != StopProgress::Now::wait) motions_.stands(all ? -1 : order.axis);
  return progress;
}

// A program that is not halted yet may restart a halted one.
StopProgress Stops::programs_end(const StopOrder& order) const {
  for (int n = 0; n < console_.model().programs; ++n) {
    const RunState run = console_.snapshot.threads[ix(n)].run;
    const bool meant = order.thread < 0 || n == order.thread;
    if (!meant || (run != RunState::running && run != RunState::held)) continue;
    if (!order.confirmed || order.times_sent < stop_attempts) return StopProgress::again();
    return StopProgress::failed(Fault(
        FaultKind::controller,
        fmt::format("Program {} is still running: another program or host starts it again.", n),
        fmt::format("Stop was sent {} times.", order.times_sent), "Stop again, or switch the power off."));
  }
  return StopProgress::stands();
}

}  // namespace hw::arcus
