#include "gui/model/jog_choice.h"

#include <utility>

#include "gui/model/tab.h"

namespace hw::gui {

template <class Change>
static void for_all_on_bus(Tab& tab, const Change& change) {
  if (!tab.bus) return change(tab.settings);
  for (Tab* member : tab.bus->members) change(member->settings);
}

void choose_jog(Tab& tab, Steps step, Pps speed) {
  for_all_on_bus(tab, [&](UserSettings& settings) {
    if (settings.profile.jog_step == step && settings.profile.jog_speed == speed) return;
    settings.profile.jog_step = step;
    settings.profile.jog_speed = speed;
    settings.edited();
  });
}

void choose_jog_speed(Tab& tab, Pps of_all) {
  for_all_on_bus(tab, [](UserSettings& settings) {
    for (AxisProfile& axis : settings.profile.axes)
      if (std::exchange(axis.jog_speed, Pps()).value > 0) settings.changed = true;
  });
  choose_jog(tab, tab.settings.profile.jog_step, of_all);
}

}  // namespace hw::gui
