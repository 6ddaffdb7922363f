#include "core/session/profile.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/session/json_file.h"

namespace hw {

using nlohmann::json;

namespace {

void put_own_unit(json& axis, const OwnUnit& own) {
  if (own.per_step != 0) axis["own_unit"] = {{"name", own.name}, {"per_step", own.per_step}};
}

OwnUnit own_unit_of(const json& axis) {
  const json kept = axis.value("own_unit", json::object());
  OwnUnit own;
  own.name = kept.value("name", own.name);
  own.per_step = kept.value("per_step", 0.0);
  const double size = std::abs(own.per_step);
  if (!(size >= 1e-12 && size <= 1e12)) own.per_step = 0;
  return own;
}

void put_travel(json& axis, const Travel& travel) {
  if (travel.has_minus) axis["minus_limit"] = travel.minus.value;
  if (travel.has_plus) axis["plus_limit"] = travel.plus.value;
  if (travel.any() && travel.in_counts) axis["limits_in_counts"] = true;
}

/// No controller counts further: sums of two such never overflow.
Steps within_reason(std::int64_t steps) {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  return Steps(std::clamp(steps, -most, most));
}

Travel travel_of(const json& axis) {
  Travel travel;
  travel.has_minus = axis.contains("minus_limit");
  travel.has_plus = axis.contains("plus_limit");
  travel.minus = within_reason(axis.value("minus_limit", std::int64_t{0}));
  travel.plus = within_reason(axis.value("plus_limit", std::int64_t{0}));
  travel.in_counts = axis.value("limits_in_counts", false);
  return travel;
}

void put_backlash(json& axis, const Backlash& backlash) {
  if (backlash.by <= Steps(0)) return;
  axis["backlash"] = backlash.by.value;
  axis["ends_in"] = std::string(1, letter(backlash.last));
}

Backlash backlash_of(const json& axis) {
  Backlash backlash;
  backlash.by = std::max(within_reason(axis.value("backlash", std::int64_t{0})), Steps(0));
  backlash.last = axis.value("ends_in", "+") == "-" ? Sign::minus : Sign::plus;
  return backlash;
}

void put_jog_speed(json& axis, Pps speed) {
  if (speed.value > 0) axis["jog_speed"] = speed.value;
}

/// 0: none.
Pps jog_speed_of(const json& object) {
  const double speed = object.value("jog_speed", 0.0);
  return Pps(speed >= 0 && speed < 1e9 ? speed : 0.0);
}

json to_json(const SavedPlaces& places) {
  json all = json::array();
  for (const SavedPlace& place : places) {
    json at = json::array();
    for (const AxisTarget& target : place.at) at.push_back({target.axis.index, target.value.value});
    all.push_back({{"name", place.name}, {"at", at}});
  }
  return all;
}

SavedPlaces saved_places(const json& profile) {
  SavedPlaces places;
  for (const json& place : profile.value("places", json::array())) {
    SavedPlace out{place.value("name", ""), {}};
    for (const json& target : place.value("at", json::array())) {
      const auto axis = target.at(0).get<std::int64_t>();
      if (axis >= 0 && axis < max_axes)
        out.at.push_back(
            {AxisId{static_cast<std::uint8_t>(axis)}, within_reason(target.at(1).get<std::int64_t>())});
    }
    if (!out.name.empty()) put_place(places, std::move(out));
  }
  return places;
}

}  // namespace

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
    profile.jog_step = within_reason(object->value("jog_step", std::int64_t{1}));
    profile.jog_speed = jog_speed_of(*object);
    profile.places = saved_places(*object);
    std::size_t i = 0;
    for (const json& axis : object->value("axes", json::array())) {
      if (i == profile.axes.size()) break;
      AxisProfile& out = profile.axes[i++];
      out.name = axis.value("name", "");
      out.unit_choice = axis.value("unit_choice", "");
      out.reversed = axis.value("reversed", false);
      out.travel = travel_of(axis);
      out.backlash = backlash_of(axis);
      out.own_unit = own_unit_of(axis);
      out.jog_speed = jog_speed_of(axis);
    }
    return profile;
  } catch (const json::exception&) {  // parses, but a field has the wrong type
    return fail(damaged(path, what));
  }
}

Result<> ProfileStore::save(std::string_view key, const Profile& profile) const {
  if (!folders_.enabled) return {};
  json axes = json::array();
  for (const AxisProfile& axis : profile.axes) {
    axes.push_back({{"name", axis.name}, {"unit_choice", axis.unit_choice}, {"reversed", axis.reversed}});
    put_travel(axes.back(), axis.travel);
    put_backlash(axes.back(), axis.backlash);
    put_own_unit(axes.back(), axis.own_unit);
    put_jog_speed(axes.back(), axis.jog_speed);
  }
  const json object = {{"controller", std::string(key)},
                       {"name", profile.name},
                       {"bus_name", profile.bus_name},
                       {"unit", profile.unit},
                       {"jog_step", profile.jog_step.value},
                       {"jog_speed", profile.jog_speed.value},
                       {"axes", axes},
                       {"places", to_json(profile.places)}};
  return write_json(file_of(key), object);
}

}  // namespace hw
