#include "core/session/recent.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/session/json_file.h"

namespace hw {

using nlohmann::json;

static bool contains(const std::vector<std::string>& addresses, std::string_view address) {
  return std::find(addresses.begin(), addresses.end(), address) != addresses.end();
}

bool RecentConnections::is_of_last_time(std::string_view address) const {
  return contains(last_time_, address);
}

Result<> RecentConnections::load() {
  list_.clear();
  last_time_.clear();
  last_end_ = {};
  if (!folders_.enabled) return {};
  const auto path = folders_.state / "recent.json";
  constexpr const char* what = "the last connections";
  const auto object = read_json(path, what);
  if (!object) return fail(object.error());
  try {
    for (const json& entry : object->value("connections", json::array())) {
      list_.push_back({entry.at("address").get<std::string>(), entry.value("name", "")});
      if (entry.value("last_time", false) && list_.size() <= capacity)
        last_time_.push_back(list_.back().address);
    }
    if (const auto closed = object->find("closed"); closed != object->end())
      last_end_ = {closed->at("date").get<std::string>(), closed->at("time").get<std::string>()};
  } catch (const json::exception&) {
    list_.clear();
    last_time_.clear();
    last_end_ = {};
    return fail(damaged(path, what));
  }
  if (list_.size() > capacity) list_.resize(capacity);
  return {};
}

Result<> RecentConnections::opened(std::string address, std::string name) {
  const auto same = [&](const RecentConnection& c) { return c.address == address; };
  const auto old = std::find_if(list_.begin(), list_.end(), same);
  if (old != list_.end()) {
    if (name.empty()) name = old->name;
    list_.erase(old);
  }
  if (!contains(this_time_, address)) this_time_.push_back(address);
  list_.insert(list_.begin(), {std::move(address), std::move(name)});
  if (list_.size() > capacity) list_.resize(capacity);
  return save();
}

Result<> RecentConnections::closed(std::string_view address) {
  const auto gone = std::erase(last_time_, address) + std::erase(this_time_, address);
  return gone > 0 ? save() : Result<>();
}

Result<> RecentConnections::ended(ClosingTime now) {
  if (this_time_.empty()) return {};
  this_end_ = std::move(now);
  return save();
}

Result<> RecentConnections::renamed(std::string_view address, std::string name) {
  for (RecentConnection& c : list_)
    if (c.address == address) c.name = name;
  return save();
}

Result<> RecentConnections::remove(std::string_view address) {
  std::erase_if(list_, [&](const RecentConnection& c) { return c.address == address; });
  std::erase(last_time_, address);
  std::erase(this_time_, address);
  return save();
}

Result<> RecentConnections::save() const {
  if (!folders_.enabled) return {};
  json list = json::array();
  const auto& together = this_time_.empty() ? last_time_ : this_time_;
  for (const RecentConnection& c : list_) {
    json entry = {{"address", c.address}, {"name", c.name}};
    if (contains(together, c.address)) entry["last_time"] = true;
    list.push_back(std::move(entry));
  }
  json object = {{"connections", std::move(list)}};
  const ClosingTime& end = this_time_.empty() ? last_end_ : this_end_;
  if (!end.date.empty()) object["closed"] = {{"date", end.date}, {"time", end.time}};
  return write_json(folders_.state / "recent.json", object);
}

}  // namespace hw
