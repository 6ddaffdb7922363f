#include "core/session/kept_positions.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/session/json_file.h"

namespace hw {

using nlohmann::json;

namespace {

constexpr const char* where_axes_stood = "where the axes stood";

template <class Enum, std::size_t count>
using Words = std::array<std::pair<Enum, const char*>, count>;

constexpr Words<Trust, 4> trust_words{{{Trust::counted, "counted"},
                                       {Trust::homed, "homed"},
                                       {Trust::set, "set"},
                                       {Trust::untrusted, "untrusted"}}};
constexpr Words<Doubt, 9> doubt_words{{{Doubt::none, "none"},
                                       {Doubt::power_cut, "power cut"},
                                       {Doubt::restarted, "restarted"},
                                       {Doubt::after_silence, "unheard"},
                                       {Doubt::reset, "reset"},
                                       {Doubt::killed, "killed"},
                                       {Doubt::slipped, "slipped"},
                                       {Doubt::zero_since, "zero since"},
                                       {Doubt::another, "another"}}};

template <class Table, class Enum>
const char* word_of(const Table& table, Enum value) {
  for (const auto& [known, word] : table)
    if (known == value) return word;
  return table[0].second;
}

/// Throws json::exception for an unknown word.
template <class Table>
auto value_of(const Table& table, const json& word) {
  for (const auto& [known, text] : table)
    if (word.get_ref<const std::string&>() == text) return known;
  throw json::other_error::create(501, "unknown word", &word);
}

std::int64_t seconds_of_day(Instant when, TwoClocks now) {
  const auto day =
      now.day + std::chrono::duration_cast<std::chrono::system_clock::duration>(when - now.session);
  return std::chrono::duration_cast<std::chrono::seconds>(day.time_since_epoch()).count();
}

Instant instant_of(std::int64_t seconds_of_day, TwoClocks now) {
  constexpr std::int64_t century_s = 3'155'760'000;  // range of the session clock around now
  const auto today_s = std::chrono::duration_cast<std::chrono::seconds>(now.day.time_since_epoch()).count();
  const std::int64_t ago_s = std::clamp(today_s - seconds_of_day, -century_s, century_s);
  return now.session - std::chrono::seconds(ago_s);
}

json json_of(const KeptPosition& axis, TwoClocks now) {
  if (!axis.known) return json::object();
  return {{"position", axis.position.value},
          {"trust", word_of(trust_words, axis.trust.kind)},
          {"doubt", word_of(doubt_words, axis.trust.cause)},
          {"since", seconds_of_day(axis.trust.since, now)}};
}

/// Beyond these, sums overflow.
std::int64_t within_range(const json& number) {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  return std::clamp(number.get<std::int64_t>(), -most, most);
}

KeptPosition kept_of(const json& object, TwoClocks now) {
  KeptPosition axis;
  if (object.empty()) return axis;
  axis.known = true;
  axis.position = Steps(within_range(object.at("position")));
  axis.trust.kind = value_of(trust_words, object.at("trust"));
  axis.trust.cause = value_of(doubt_words, object.at("doubt"));
  axis.trust.since = instant_of(within_range(object.at("since")), now);
  return axis;
}

}  // namespace

std::filesystem::path KeptPositions::file_of(std::string_view key) const {
  return folders_.state / "positions" / (file_name_for(key) + ".json");
}

Result<std::vector<KeptPosition>> KeptPositions::load(std::string_view key, TwoClocks now) const {
  std::vector<KeptPosition> axes;
  if (!folders_.enabled) return axes;
  const auto object = read_json(file_of(key), where_axes_stood);
  if (!object) return fail(object.error());
  try {
    for (const json& axis : object->value("axes", json::array())) axes.push_back(kept_of(axis, now));
    return axes;
  } catch (const json::exception&) {
    return fail(damaged(file_of(key), where_axes_stood));
  }
}

Result<> KeptPositions::save(std::string_view key, const std::vector<KeptPosition>& axes,
                             TwoClocks now) const {
  if (!folders_.enabled) return {};
  json list = json::array();
  for (const KeptPosition& axis : axes) list.push_back(json_of(axis, now));
  return write_json(file_of(key), {{"key", key}, {"axes", list}});
}

}  // namespace hw
