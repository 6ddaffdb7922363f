#include "core/session/last_end.h"

#include <algorithm>
#include <ctime>
#include <nlohmann/json.hpp>

#include <fmt/core.h>

#include "core/session/json_file.h"

namespace hw {

using nlohmann::json;

constexpr const char* what_it_is = "how the last session ended";

static std::string_view outcome_words(LastEnd::Outcome outcome) {
  switch (outcome) {
    case LastEnd::Outcome::at_rest: return "it was stopped, and confirmed at rest.";
    case LastEnd::Outcome::stop_sent:
      return "a stop was sent, but the program ended before it was seen at rest. Check it first.";
    case LastEnd::Outcome::no_stop_sent:
      return "no stop could be sent, because there was no link. It may still be moving: check it first.";
    case LastEnd::Outcome::left_alone: break;
  }
  return "this was not started here, and was left running.";
}

std::string LastEnd::sentence(const std::string& today) const {
  const std::string when =
      date == today ? fmt::format("At {}", time) : fmt::format("On {} at {}", date, time);
  std::string all = fmt::format("{} the session was ended ({}).", when, how);
  for (const Controller& c : controllers)
    all += fmt::format(" {}: {}; {}", c.name, c.what, outcome_words(c.outcome));
  return all;
}

bool LastEnd::harmless() const {
  return std::all_of(controllers.begin(), controllers.end(), [](const Controller& c) {
    return c.outcome == Outcome::at_rest || c.outcome == Outcome::left_alone;
  });
}

static json json_of(const LastEnd& end) {
  json controllers = json::array();
  for (const auto& c : end.controllers)
    controllers.push_back({{"name", c.name}, {"what", c.what}, {"fate", static_cast<int>(c.outcome)}});
  return {{"date", end.date}, {"time", end.time}, {"how", end.how}, {"controllers", controllers}};
}

static LastEnd end_of(const json& object) {
  LastEnd end;
  object.at("date").get_to(end.date), object.at("time").get_to(end.time), object.at("how").get_to(end.how);
  for (const json& c : object.at("controllers")) {
    const int outcome =
        std::clamp(c.at("fate").get<int>(), 0, static_cast<int>(LastEnd::Outcome::left_alone));
    end.controllers.push_back({c.at("name").get<std::string>(), c.at("what").get<std::string>(),
                               static_cast<LastEnd::Outcome>(outcome)});
  }
  return end;
}

Result<std::vector<LastEnd>> LastEnds::read() const {
  std::vector<LastEnd> ends;
  const auto object = read_json(file(), what_it_is);
  if (!object) return fail(object.error());
  try {
    for (const json& one : object->value("ends", json::array())) ends.push_back(end_of(one));
    return ends;
  } catch (const json::exception&) {
    return fail(damaged(file(), what_it_is));
  }
}

Result<> LastEnds::keep(const LastEnd& end) const {
  if (!folders_.enabled) return {};
  std::vector<LastEnd> ends = read().value_or(std::vector<LastEnd>());
  std::erase_if(
      ends, [&](const LastEnd& e) { return e.date == end.date && e.time == end.time && e.how == end.how; });
  ends.push_back(end);
  json list = json::array();
  for (const LastEnd& e : ends) list.push_back(json_of(e));
  return write_json(file(), {{"ends", list}});
}

Result<std::vector<LastEnd>> LastEnds::take() const {
  if (!folders_.enabled) return std::vector<LastEnd>();
  auto ends = read();
  std::error_code ignored;
  if (ends) std::filesystem::remove(file(), ignored);
  return ends;
}

std::string date_of_today() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  char text[16];
  return std::string(text, std::strftime(text, sizeof text, "%Y-%m-%d", &local));
}

}  // namespace hw
