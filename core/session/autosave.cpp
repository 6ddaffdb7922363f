#include "core/session/autosave.h"

#include <nlohmann/json.hpp>

#include "core/session/json_file.h"

namespace hw {

using nlohmann::json;

std::filesystem::path Autosave::file_of(std::string_view key) const {
  return folders_.state / "unsaved" / (file_name_for(key) + ".json");
}

Result<> Autosave::keep(std::string_view key, const std::vector<UnsavedText>& texts) const {
  if (!folders_.enabled) return {};
  if (texts.empty()) {
    std::error_code ignored;
    std::filesystem::remove(file_of(key), ignored);
    return {};
  }
  json list = json::array();
  for (const UnsavedText& t : texts) list.push_back({{"slot", t.slot}, {"path", t.path}, {"text", t.text}});
  return write_json(file_of(key), {{"controller", std::string(key)}, {"texts", list}});
}

Result<std::vector<UnsavedText>> Autosave::restore(std::string_view key) const {
  if (!folders_.enabled) return std::vector<UnsavedText>();
  const auto path = file_of(key);
  constexpr const char* what = "unsaved program texts";
  const auto object = read_json(path, what);
  if (!object) return fail(object.error());
  try {
    std::vector<UnsavedText> texts;
    for (const json& entry : object->value("texts", json::array()))
      texts.push_back(
          {entry.at("slot").get<int>(), entry.at("text").get<std::string>(), entry.value("path", "")});
    return texts;
  } catch (const json::exception&) {
    return fail(damaged(path, what));
  }
}

}  // namespace hw
