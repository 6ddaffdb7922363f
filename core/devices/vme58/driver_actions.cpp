// The catalog's actions.
#include <cmath>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/action_check.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {

Task<Result<>> Vme58Driver::act(intent::Act wish) {
  if (auto may = commands_.may_talk(); !may) co_return may;
  if (auto possible = check_action(catalog_, wish); !possible) co_return possible;
  const ActionInfo& info = catalog_.actions[ix(wish.action)];
  const bool of_axis = !info.fields.empty() && info.fields.front().id == "axis";
  const int axis = of_axis ? static_cast<int>(wish.values[0]) : 0;
  std::string text;
  switch (static_cast<Action>(wish.action)) {
    case Action::clear_flags:
      for (std::size_t i = 0; i < catalog_.readouts.size(); ++i)
        if (catalog_.readouts[i].group == flag_group) draft_.readouts[i] = 0;
      co_return co_await commands_.say("IC\n", Priority::intent);
    case Action::flush:
      forget_put_velocities(axis);
      text = "FL";
      break;
    case Action::fraction_jog:
      if (auto may = may_move(axis); !may) co_return may;
      text = addressed(axis, "JF" + encode_number(wish.values[1], 3));
      if (wish.values[1] == 0) co_return co_await commands_.say(std::move(text), Priority::intent);
      minds_[ix(axis)].jog_gap = jog_gap(axis, std::abs(static_cast<double>(wish.values[1])) / 1000);
      co_return co_await begin_jog(std::move(text), axis);
    case Action::remainder:
      minds_[ix(axis)].counted = true;
      draft_.working = queues_due_ = true;
      text = fmt::format("RM{}", wish.values[1]);
      break;
    case Action::clear_while: text = "CW"; break;
    case Action::force_position:
      forget_put_velocities(axis);  // it empties the queue too
      text = fmt::format("FP{}", wish.values[1]);
      break;
    case Action::encoder_ratio: text = fmt::format("ER{},{}", wish.values[1], wish.values[2]); break;
    case Action::hold:
      if (catalog_.axes[ix(axis)].servo)
        co_return co_await switch_loop(axis, wish.values[1] != 0, wish.closing);
      text = wish.values[1] != 0 ? "HN" : "HF";
      break;
    case Action::track:
      minds_[ix(axis)].servo.goes_to_place = false;
      text = "ET";
      break;
    case Action::slip_interrupt: text = "IS"; break;
  }
  const std::string whole = addressed(axis, text);
  co_return co_await commands_.say(whole, Priority::intent);
}

}  // namespace hw::vme58
