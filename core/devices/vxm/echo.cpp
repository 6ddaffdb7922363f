#include "core/devices/vxm/echo.h"

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/greeting.h"

namespace hw::vxm {
namespace {

constexpr int attempts_to_end_echo = 4;

}  // namespace

Task<Result<>> Echo::end(char state) {
  if (state != ready) {
    if (!std::exchange(reported_, true))
      console_.report(Notice::Kind::warning,
                      "The controller echoes each command until its program ends. Until then "
                      "inputs, outputs and limits are not read, and the console sends only stops.");
    co_return Result<>();
  }
  for (int n = 0; n < attempts_to_end_echo && conversation_.echoes(); ++n) {
    auto sent = co_await conversation_.transmit_anyway("F");
    if (!sent) co_return sent;
    auto quiet = co_await conversation_.wait_for_quiet();
    if (!quiet) co_return quiet;
    auto reply = co_await conversation_.greet(slow_greeting_quiet_ms);
    if (!reply && reply.error().kind != FaultKind::no_answer) co_return fail(reply.error());
    const Greeting greeting = reply ? read_greeting(*reply) : Greeting();
    if (greeting.is_a_vxm() && !greeting.echo) conversation_.set_echoes(false);
    if (greeting.is_a_vxm() && greeting.state != ready) co_return Result<>();  // a run has begun
  }
  if (conversation_.echoes())
    co_return fail(FaultKind::garbled, "The controller still echoes each command, although F was sent.", {},
                   "Check whether another program uses it, or a device on the line echoes bytes.");
  reported_ = false;
  console_.report(Notice::Kind::info, "The controller echoed each command. Echo was switched off.");
  co_return Result<>();
}

Task<Result<>> Echo::end_before_request() {
  if (!conversation_.echoes()) co_return Result<>();
  auto state = co_await conversation_.state(Priority::intent);
  if (!state) co_return fail(state.error());
  auto ended = co_await end(*state);
  if (!ended || !conversation_.echoes()) co_return ended;
  co_return fail(FaultKind::refused, "The controller echoes each command until its program ends.",
                 "Nothing was sent.", "Wait until the program ends, or stop it by the Stop button.");
}

}  // namespace hw::vxm
