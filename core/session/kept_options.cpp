#include "core/session/kept_options.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/session/json_file.h"

namespace hw {

using nlohmann::json;

const double* KeptOptions::number(std::string_view name) const {
  const auto found = numbers.find(name);
  return found == numbers.end() ? nullptr : &found->second;
}

const std::string* KeptOptions::word(std::string_view name) const {
  const auto found = words.find(name);
  return found == words.end() ? nullptr : &found->second;
}

std::filesystem::path KeptOptionsOfDrawings::file_of(std::string_view key) const {
  return folders_.config / "drawings" / (file_name_for(key) + ".json");
}

Result<KeptOptions> KeptOptionsOfDrawings::load(std::string_view key) const {
  if (!folders_.enabled) return KeptOptions();
  const auto path = file_of(key);
  constexpr const char* what = "the scale, table and tool of drawings";
  const auto object = read_json(path, what);
  if (!object) return fail(object.error());
  try {
    KeptOptions kept;
    const json options = object->value("options", json::object());
    for (const auto& [name, value] : options.items()) {
      if (value.is_string())
        kept.words[name] = value.get<std::string>();
      else if (const double number = value.get<double>(); std::isfinite(number))
        kept.numbers[name] = number;
    }
    return kept;
  } catch (const json::exception&) {  // parses, but a field has the wrong type
    return fail(damaged(path, what));
  }
}

Result<> KeptOptionsOfDrawings::save(std::string_view key, const KeptOptions& options) const {
  if (!folders_.enabled) return {};
  json all = json::object();
  for (const auto& [name, number] : options.numbers) all[name] = number;
  for (const auto& [name, word] : options.words) all[name] = word;
  return write_json(file_of(key), {{"controller", std::string(key)}, {"options", all}});
}

}  // namespace hw
