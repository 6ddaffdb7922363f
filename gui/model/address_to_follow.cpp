#include "gui/model/address_to_follow.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include <fmt/core.h>

#include "core/session/moved_address.h"
#include "core/session/session_group.h"
#include "gui/model/tab.h"

namespace hw::gui {
namespace {

std::optional<Address> moved(const Tab& tab) {
  return moved_address(tab.catalog(), tab.now(), tab.address());
}

Address goes_by(const Tab& tab) { return moved(tab).value_or(tab.address()); }

std::string option_of(const Address& address, const std::string& key) {
  const auto found = address.options.find(key);
  return found == address.options.end() ? std::string() : found->second;
}

/// "01-04"; empty: the ids are not consecutive, or two are equal.
std::string as_range(const std::set<std::string>& ids, std::size_t count) {
  if (ids.size() != count) return {};
  const int first = std::atoi(ids.begin()->c_str()), last = std::atoi(ids.rbegin()->c_str());
  return static_cast<std::size_t>(last - first) + 1 == count
             ? fmt::format("{}-{}", *ids.begin(), *ids.rbegin())
             : std::string();
}

std::optional<Address> followed_by_all(const Bus& bus) {
  const auto has_moved = [](const Tab* member) { return moved(*member).has_value(); };
  if (!bus.group || std::none_of(bus.members.begin(), bus.members.end(), has_moved)) return {};
  Address to = bus.group->address();
  const std::string before = to.text();
  const std::string rate = option_of(goes_by(*bus.members.front()), "baud");
  std::set<std::string> ids;
  for (const Tab* member : bus.members) {
    const Address at = goes_by(*member);
    if (option_of(at, "baud") != rate) return {};
    ids.insert(option_of(at, "id"));
  }
  const std::string range = as_range(ids, bus.members.size());
  if (range.empty()) return {};
  to.options["id"] = range;
  if (!rate.empty()) to.options["baud"] = rate;
  return to.text() == before ? std::nullopt : std::optional(to);
}

}  // namespace

std::optional<Address> address_to_follow(const Tab& tab) {
  if (tab.bus) return followed_by_all(*tab.bus);
  return moved(tab);
}

TabProfiles::TabProfiles(Tab& tab) {
  const auto take = [this](const Tab& of) {
    all_.push_back({of.bus ? option_of(goes_by(of), "id") : std::string(), of.settings.profile});
  };
  if (tab.bus)
    for (const Tab* member : tab.bus->members) take(*member);
  else
    take(tab);
}

void TabProfiles::apply_to(Tab& tab) const {
  const auto give = [this](Tab& to) {
    const auto of = std::find_if(all_.begin(), all_.end(),
                                 [&](const Of& one) { return one.id.empty() || one.id == to.id(); });
    if (of == all_.end()) return;
    to.settings.profile = of->profile;
    to.settings.edited();
  };
  if (!tab.bus) return give(tab);
  for (Tab* member : tab.bus->members) give(*member);
}

}  // namespace hw::gui
