#include "core/link/link_wills.h"

#include <algorithm>
#include <utility>

#include "core/link/link_log.h"

namespace hw {

void LinkWills::entrust_to(std::shared_ptr<WillKeeper> keeper, bool emulated, bool reachable) {
  keeper_ = std::move(keeper);
  emulated_here_ = emulated;
  reachable_ = reachable;
}

std::shared_ptr<WillKeeper::Will> LinkWills::leave(Scheduler& scheduler, const WireShare& wire,
                                                   const LastWill& will) {
  if (!keeper_ || wire.how == WireShare::How::none) {
    link_log().debug("no watchdog guards the held jog: {}",
                     keeper_ ? "this wire cannot be shared with it" : "it does not run");
    return nullptr;
  }
  auto left = keeper_->leave(scheduler, wire, will);
  link_log().debug(
      "{}", left ? "the watchdog guards a held jog" : "the watchdog did not accept the last will of a jog");
  if (left) left_.push_back(left);
  return left;
}

JogEnds LinkWills::jog_ends() const {
  if (emulated_here_) return JogEnds::with_program;
  const bool reached = keeper_ && reachable_ && keeper_->is_there();
  return reached ? JogEnds::by_watchdog : JogEnds::never;
}

bool LinkWills::may_be_carried_out() {
  std::erase_if(left_, [](const auto& will) { return will.expired(); });
  return std::any_of(left_.begin(), left_.end(), [](const auto& will) {
    const auto left = will.lock();
    return left && left->may_be_carried_out();
  });
}

}  // namespace hw
