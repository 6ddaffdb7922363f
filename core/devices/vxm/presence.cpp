#include "core/devices/vxm/presence.h"

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {

Task<Result<>> Presence::go_on_line() {
  for (const bool again : {false, true}) {
    auto sent = co_await conversation_.transmit_anyway("F");
    if (!sent) co_return sent;
    auto state = co_await conversation_.state(Priority::intent);
    if (!state) co_return fail(state.error());
    if (*state == ready || *state == busy) break;
    if (again)
      co_return fail(
          FaultKind::controller, "The controller stays in Local mode although F was sent to put it on-line.",
          {},
          "Let go of all buttons at its front panel; if its green lamp flashes, wait until it is steady.");
  }
  seen_on_line();
  co_return Result<>();
}

void Presence::halted_by(char letter) {
  halted_ = letter;
  ask_again_at_ = scheduler_.now() + std::chrono::seconds(1);
}

bool Presence::is_to_be_asked_again() {
  if (scheduler_.now() < ask_again_at_) return false;
  ask_again_at_ = scheduler_.now() + std::chrono::seconds(1);
  return true;
}

}  // namespace hw::vxm
