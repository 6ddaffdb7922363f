#include "core/devices/vxm/hold_switch.h"

namespace hw::vxm {

Result<> HoldSwitch::may_switch() const {
  if (hold_.is_known()) return {};
  return fail(
      FaultKind::refused,
      hold_.is_doubtful()
          ? "The connection was lost while the hold was being switched: whether it is on is unknown."
          : "Another program or a button started this run: whether it is held shows when a motor starts.",
      "Nothing was sent.", "Stop the program.");
}

Task<Result<>> HoldSwitch::transmit(std::string text, bool on, Priority priority) {
  const bool switches = text.starts_with('H');
  auto sent = co_await conversation_.transmit(std::move(text), priority);
  if (sent) hold_.was_switched(on);
  if (!sent && switches && sent.error().kind == FaultKind::lost) hold_.doubt();
  co_return sent;
}

// Another H would switch on a hold that has ended. K ends the hold in either case, and is answered.
Task<Result<>> HoldSwitch::settle() {
  if (!hold_.is_doubtful()) co_return Result<>();
  auto settled = co_await kills_.kill(true, Priority::intent);
  if (settled || settled.error().kind != FaultKind::no_answer) co_return settled;
  co_return fail(
      FaultKind::no_answer,
      "Whether the hold (H) is on is unknown, and the controller does not confirm the K that ends it.",
      "Nothing else was sent.", "Try again.");
}

}  // namespace hw::vxm
