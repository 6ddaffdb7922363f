#include "core/devices/vxm/status.h"

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {

Task<Result<>> Status::take(char state) {
  if (state == jog_idle || state == jog_moving) {
    if (presence_.stays_local()) co_return Result<>();
    co_return co_await restarts_.found("The controller has gone to Local mode");
  }
  presence_.seen_on_line();
  if (state == ready && presence_.reset_was_sent()) co_return co_await restarts_.found_reset_on_line();
  ProgramState& program = console_.snapshot.program;
  if (state == busy && !under_way_.busy()) {
    under_way_.program_begins(-1);  // by the Run button, or from before this connection
  } else if (state == ready && under_way_.job().active()) {
    under_way_.job().leg_is_over();  // the prompt of the leg was lost, or comes in the next moment
    under_way_.news().notify();
  } else if (state == ready && under_way_.program_runs()) {
    under_way_.run_ended(EndedBy::target);
  } else if (state == ready && program.run != RunState::error) {
    // Overrides an unexpected message.
    if (program.run == RunState::held) hold_.doubt();
    program.run = RunState::idle;
  }
  co_return Result<>();
}

Task<Result<>> Status::clean_if_dirty() {
  if (!presence_.is_on_line() || presence_.is_halted() || !conversation_.station() ||
      !conversation_.station()->is_dirty())
    co_return Result<>();
  auto state = co_await conversation_.state(Priority::intent);
  if (!state) co_return fail(state.error());
  co_return co_await take(*state);
}

Task<Result<>> Status::ask_again_while_silent() {
  if (!presence_.is_to_be_asked_again()) co_return Result<>();
  auto reply = co_await conversation_.ask_while_silent();
  if (!reply) co_return reply.error().kind == FaultKind::lost ? fail(reply.error()) : Result<>();
  const auto state = decode_state(*reply);
  if (!state || !presence_.is_halted()) co_return Result<>();
  under_way_.killed(EndedBy::error);
  co_return co_await take(*state);
}

}  // namespace hw::vxm
