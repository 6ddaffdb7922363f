#include "core/devices/vme58/actions.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/action_check.h"
#include "core/devices/vme58/catalog.h"

namespace hw::vme58 {

Task<Result<>> Actions::act(intent::Act request) {
  if (auto may = commands_.may_talk(); !may) co_return may;
  if (auto possible = check_action(catalog_, request); !possible) co_return possible;
  const ActionInfo& info = catalog_.actions[ix(request.action)];
  const bool of_axis = !info.fields.empty() && info.fields.front().id == "axis";
  const int axis = of_axis ? static_cast<int>(request.values[0]) : 0;
  std::string text;
  switch (static_cast<Action>(request.action)) {
    case Action::clear_flags:
      clear_flags();
      text = "IC\n";
      co_return co_await commands_.transmit(std::move(text), Priority::intent);
    case Action::flush:
      speeds_.forget_put(axis);
      text = "FL";
      break;
    case Action::fraction_jog: co_return co_await moves_.jog_slowly(axis, request.values[1]);
    case Action::remainder:
      motions_.counts(axis);
      next_.awaits_queues();
      text = fmt::format("RM{}", request.values[1]);
      break;
    case Action::clear_while: text = "CW"; break;
    case Action::force_position:
      speeds_.forget_put(axis);  // the command empties the queue too
      text = fmt::format("FP{}", request.values[1]);
      break;
    case Action::encoder_ratio: text = fmt::format("ER{},{}", request.values[1], request.values[2]); break;
    case Action::hold:
      if (loops_.is_servo(axis))
        co_return co_await drive_.switch_loop(axis, request.values[1] != 0, request.closing);
      text = request.values[1] != 0 ? "HN" : "HF";
      break;
    case Action::track:
      loops_.leaves_its_place(axis);
      text = "ET";
      break;
    case Action::slip_interrupt: text = "IS"; break;
  }
  std::string whole = selection_.addressed(axis, text);
  co_return co_await commands_.transmit(std::move(whole), Priority::intent);
}

void Actions::clear_flags() {
  for (std::size_t i = 0; i < catalog_.readouts.size(); ++i)
    if (catalog_.readouts[i].group == flag_group) snapshot_.readouts[i] = 0;
}

}  // namespace hw::vme58
