#include "core/devices/vxm/opening.h"

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/greeting.h"

namespace hw::vxm {
namespace {

constexpr int greetings = 4, silences_until_absent = 2;

}  // namespace

// Sends V alone first: it moves nothing in any mode. A carriage return then ends an unfinished command.
// Replies to that command, or garbage on a freshly opened line, are ignored.
Task<Result<std::string>> Opening::ask_for_greeting() {
  std::string bytes;
  int silences = 0;
  for (int n = 0; n < greetings && silences < silences_until_absent; ++n) {
    if (n > 0) {
      auto ended = co_await conversation_.transmit_anyway("\r");
      if (!ended) co_return fail(ended.error());
      auto quiet = co_await conversation_.wait_for_quiet();
      if (!quiet) co_return fail(quiet.error());
    }
    const auto quiet_ms = n > 0 ? slow_greeting_quiet_ms : greeting_quiet_ms;
    auto reply = co_await conversation_.greet(quiet_ms);
    if (!reply && reply.error().kind != FaultKind::no_answer) co_return fail(reply.error());
    if (!reply) ++silences;
    if (reply) bytes = *reply;
    if (reply && read_greeting(bytes).is_a_vxm()) break;
  }
  co_return bytes;
}

Task<Result<>> Opening::greet() {
  auto bytes = co_await ask_for_greeting();
  if (!bytes) co_return fail(bytes.error());
  Greeting greeting = read_greeting(*bytes);
  const int rate = conversation_.station() ? conversation_.station()->rate() : 0;
  if (bytes->empty()) co_return no_greeting(rate);
  if (!greeting.is_a_vxm()) co_return no_vxm_greets(*bytes, rate);
  // It may be the reply to a V before a restart, and F removes the only sign of that.
  for (int n = 0; n < greetings && conversation_.station() && conversation_.station()->is_dirty(); ++n) {
    auto again = co_await conversation_.greet(greeting_quiet_ms);
    if (!again && again.error().kind != FaultKind::no_answer) co_return fail(again.error());
    if (again && read_greeting(*again).is_a_vxm()) greeting = read_greeting(*again);
  }
  if (conversation_.station() && conversation_.station()->is_dirty())
    presence_.left_local(Presence::LeftLocal::perhaps);
  conversation_.set_echoes(greeting.echo);
  if (greeting.state == jog_idle || greeting.state == jog_moving)
    co_return co_await found_local(greeting.state);
  if (presence_.is_halted())
    under_way_.killed(EndedBy::error);  // the error is over: the controller accepts commands again
  presence_.seen_on_line();
  // F ends the echo and the carriage returns after prompts, also if another host switched them on.
  auto sent = co_await conversation_.transmit_anyway("F");
  if (!sent) co_return sent;
  auto state = co_await conversation_.state(Priority::intent);
  if (!state) co_return fail(state.error());
  if (greeting.echo) {
    auto ended = co_await echo_.end(*state);
    if (!ended) co_return ended;
  }
  auto resumed = co_await resume_after_loss(*state);
  if (!resumed || !presence_.was_found_before()) co_return resumed;
  switch (presence_.take_left_local()) {
    case Presence::LeftLocal::no: break;
    case Presence::LeftLocal::perhaps: co_return co_await restarts_.may_have_left_local();
    case Presence::LeftLocal::yes: co_return co_await restarts_.found_left_local();
  }
  co_return resumed;
}

// On first contact, Local mode is the usual state after power-up. Later it means a restart.
Task<Result<>> Opening::found_local(char state) {
  if (presence_.was_found_before() && !presence_.stays_local())
    co_return co_await restarts_.found("It answers from Local mode");
  presence_.wants_on_line();
  auto on_line = co_await presence_.go_on_line();
  if (!on_line) co_return on_line;
  console_.report(Notice::Kind::info,
                  state == jog_moving
                      ? "A motor was being jogged by the controller's buttons. The controller is on-line "
                        "now: its jog buttons are off."
                      : "The controller was in Local mode. It is on-line now: its jog buttons are off.");
  co_return Result<>();
}

// After a lost wire the state is read again. Motions went on without the console.
Task<Result<>> Opening::resume_after_loss(char state) {
  if (state == ready && under_way_.job().active())
    under_way_.job().leg_is_over(), under_way_.job().ends_by(EndedBy::lost);
  if (state == vxm::busy && !under_way_.job().active()) {
    const bool others = !under_way_.program_runs() || !hold_.is_known();  // kept for another loss of the wire
    under_way_.program_begins(-1);
    if (others) hold_.found_running();
  }
  if (state == vxm::busy && under_way_.job().active()) legs_.show_leg(under_way_.job().leg());
  if (!under_way_.take_lost_while_busy()) co_return Result<>();
  co_return co_await positions_.read(Priority::intent, state == ready);
}

}  // namespace hw::vxm
