#include "gui/model/user_settings.h"

#include <utility>

namespace hw::gui {

UserSettings::UserSettings(const Catalog& catalog, std::string key_of_profile, Send send)
    : key(std::move(key_of_profile)), catalog_(catalog), send_(std::move(send)) {
  units_.work_out(catalog_, profile);
}

void UserSettings::edited() {
  changed = true;
  units_.work_out(catalog_, profile);
  send_limits();
}

void UserSettings::send_limits() {
  for (std::size_t i = 0; i < catalog_.axes.size(); ++i)
    if (const Travel& travel = profile.axes[i].travel; travel != std::exchange(sent_.travel[i], travel))
      send_(intent::SetTravel(AxisId{static_cast<std::uint8_t>(i)}, travel));
  for (std::size_t i = 0; i < catalog_.axes.size(); ++i)
    if (const Backlash& backlash = profile.axes[i].backlash;
        backlash != std::exchange(sent_.backlash[i], backlash))
      send_(intent::SetBacklash(AxisId{static_cast<std::uint8_t>(i)}, backlash));
}

std::string_view UserSettings::name() const {
  if (!profile.name.empty()) return profile.name;
  return default_name.empty() ? std::string_view(catalog_.short_name) : std::string_view(default_name);
}

PlaceWords UserSettings::place_words() const {
  return [this](AxisId axis, Steps place) { return std::string(format_with_unit(place, unit(axis)).view()); };
}

Pps UserSettings::jog_speed(AxisId axis) const {
  const Pps own = profile.axes[axis.index].jog_speed;
  return own.value > 0 ? own : profile.jog_speed;
}

void UserSettings::choose_jog_speed(AxisId axis, Pps speed) {
  if (std::exchange(profile.axes[axis.index].jog_speed, speed) != speed) edited();
}

}  // namespace hw::gui
