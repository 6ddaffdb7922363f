#include "core/session/profile.h"

#include <nlohmann/json.hpp>

#include "core/session/json_file.h"

namespace hw {

using nlohmann::json;

std::string profile_key(const Address& address, std::string_view usb_serial) {
  if (!usb_serial.empty()) return "usb-" + std::string(usb_serial);
  return address.transport == "serial" ? address.where : address.text();
}

std::filesystem::path ProfileStore::file_of(std::string_view key) const {
  return folders_.config / "profiles" / (file_name_for(key) + ".json");
}

Result<Profile> ProfileStore::load(std::string_view key) const {
  if (!folders_.enabled) return Profile();
  const auto path = file_of(key);
  constexpr const char* what = "the name and units of this controller";
  const auto object = read_json(path, what);
  if (!object) return fail(object.error());
  try {
    Profile profile;
    profile.name = object->value("name", "");
    profile.bus_name = object->value("bus_name", "");
    profile.unit = object->value("unit", "");
    profile.jog_step = Steps(object->value("jog_step", std::int64_t{1}));
    profile.jog_speed = Pps(object->value("jog_speed", 0.0));
    std::size_t i = 0;
    for (const json& axis : object->value("axes", json::array())) {
      if (i == profile.axes.size()) break;
      AxisProfile& out = profile.axes[i++];
      out.name = axis.value("name", "");
      out.unit_choice = axis.value("unit_choice", "");
      out.reversed = axis.value("reversed", false);
    }
    return profile;
  } catch (const json::exception&) {  // parses, but a field is of the wrong kind
    return fail(damaged(path, what));
  }
}

Result<> ProfileStore::save(std::string_view key, const Profile& profile) const {
  if (!folders_.enabled) return {};
  json axes = json::array();
  for (const AxisProfile& axis : profile.axes)
    axes.push_back({{"name", axis.name}, {"unit_choice", axis.unit_choice}, {"reversed", axis.reversed}});
  const json object = {{"controller", std::string(key)},
                       {"name", profile.name},
                       {"bus_name", profile.bus_name},
                       {"unit", profile.unit},
                       {"jog_step", profile.jog_step.value},
                       {"jog_speed", profile.jog_speed.value},
                       {"axes", axes}};
  return write_json(file_of(key), object);
}

}  // namespace hw
