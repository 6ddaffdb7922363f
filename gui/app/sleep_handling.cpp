#include "gui/app/sleep_handling.h"

#include <algorithm>

namespace hw::app {
namespace {

template <class Is>
bool any_axis(const gui::Console& console, Is is) {
  for (const auto& tab : console.tabs()) {
    const Snapshot& now = tab->now();
    if (!now.link.connected()) continue;
    for (int i = 0; i < now.axis_count; ++i)
      if (is(now.axes[static_cast<std::size_t>(i)])) return true;
  }
  return false;
}

bool jogs(const gui::Console& console) {
  return any_axis(console, [](const AxisState& axis) {
    return axis.activity == Activity::jogging || axis.activity == Activity::stopping;
  });
}

bool something_moves(const gui::Console& console) {
  const auto& tabs = console.tabs();
  return std::any_of(tabs.begin(), tabs.end(), [](const auto& tab) {
    const Snapshot& now = tab->now();
    const RunState run = now.program.run;
    return now.link.connected() &&
           (now.any_axis_moving() || run == RunState::running || run == RunState::waiting);
  });
}

}  // namespace

SleepHandling::SleepHandling(Scheduler& scheduler, std::function<void()> wake)
    : watch_(scheduler, {[this, wake] {
                           wants_to_sleep_ = true;
                           wake();
                         },
                         [this, wake] {
                           has_woken_ = true;
                           wake();
                         }}) {}

void SleepHandling::follow(gui::Console& console) {
  if (wants_to_sleep_.exchange(false)) {
    console.let_go();
    makes_ready_ = true;
  }
  if (has_woken_.exchange(false)) {
    makes_ready_ = false;
    for (const auto& tab : console.tabs()) tab->send(intent::ReadAgain());
    if (!console.tabs().empty())
      console.toast(gui::Severity::warn,
                    "The computer was asleep. The state of each controller is read again.");
  }
  if (makes_ready_ && !jogs(console)) {
    makes_ready_ = false;
    watch_.may_sleep();
  }
  if (const bool moves = something_moves(console); moves != keeps_awake_)
    watch_.keep_awake(keeps_awake_ = moves);
}

}  // namespace hw::app
