#include "core/session/json_file.h"

#include <nlohmann/json.hpp>

#include <fmt/core.h>

#include "core/base/shown_text.h"
#include "core/session/user_files.h"

namespace hw {

using nlohmann::json;

namespace {

constexpr int deepest_json = 32;
constexpr std::size_t longest_json_name = 200, longest_json_word = 5000;
constexpr const char* version_key = "version";
constexpr std::int64_t newest_version = 1;

/// Texts and paths are kept byte by byte; every other word is a name, or a sentence, to be shown.
bool is_kept_as_it_is(std::string_view key) {
  return key == "text" || key == "path" || key == "key" || key == "controller" || key == "options";
}

std::size_t longest_word_of(std::string_view key) {
  return key == "text" ? std::string::npos : longest_json_word;
}

/// Cuts between characters, never within one.
void cut_to(std::size_t most, std::string& word) {
  if (word.size() <= most) return;
  while (most > 0 && (static_cast<unsigned char>(word[most]) & 0xC0) == 0x80) --most;
  word.resize(most);
}

/// The console's files are never deeply nested. Copying a value recurses, so a deeper one is refused. So is a
/// key that would fill the screen; a word is cut, which loses less than the whole file.
json parse_small(const std::string& bytes) {
  bool fits = true;
  std::string key;
  const auto look = [&](int depth, json::parse_event_t event, json& part) {
    if (depth > deepest_json) fits = false;
    if (event == json::parse_event_t::key) {
      key = part.get_ref<const std::string&>();
      if (key.size() > longest_json_name) fits = false;
    }
    if (event == json::parse_event_t::value && part.is_string())
      cut_to(longest_word_of(key), part.get_ref<std::string&>());
    return fits;
  };
  json object = json::parse(bytes, look, false);
  return fits ? object : json(json::value_t::discarded);
}

/// Escapes characters that would disturb a line on the screen. For names that are shown.
void write_out(json& part) {
  if (part.is_string()) part = shown_text(part.get_ref<const std::string&>(), longest_json_word);
  if (part.is_array())
    for (json& one : part) write_out(one);
  if (!part.is_object()) return;
  for (auto& [key, value] : part.items())
    if (!is_kept_as_it_is(key)) write_out(value);
}

bool is_newer(const json& object) {
  const auto version = object.find(version_key);
  return version != object.end() && version->is_number_integer() &&
         version->get<std::int64_t>() > newest_version;
}

/// Set aside: overwriting it would lose data of the newer program.
Fault newer(const std::filesystem::path& path, std::string_view what_it_is) {
  const auto aside = set_aside(path, ".newer");
  return Fault(FaultKind::text,
               fmt::format("The file with {} was written by a newer version of Handwheel ({}).", what_it_is,
                           path.string()),
               aside.empty() ? "It was left as it is and is not used."
                             : fmt::format("It was renamed to {}, and a new file was started.",
                                           aside.filename().string()));
}

}  // namespace

Fault damaged(const std::filesystem::path& path, std::string_view what_it_is) {
  const auto aside = set_aside(path);
  return Fault(FaultKind::text, fmt::format("The file with {} is damaged ({}).", what_it_is, path.string()),
               aside.empty() ? "It was left as it is and is not used."
                             : fmt::format("It was renamed to {}, and a new file was started.",
                                           aside.filename().string()));
}

Result<json> read_json(const std::filesystem::path& path, std::string_view what_it_is) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return json::object();
  constexpr std::uintmax_t largest = 16'000'000;
  auto bytes = read_file(path, largest);
  if (!bytes) return fail(bytes.error());
  json object = parse_small(*bytes);
  if (object.is_discarded() || !object.is_object()) return fail(damaged(path, what_it_is));
  if (is_newer(object)) return fail(newer(path, what_it_is));
  write_out(object);
  return object;
}

Result<> write_json(const std::filesystem::path& path, const json& object) {
  make_private_folder(path.parent_path());
  json written = object;
  written[version_key] = newest_version;
  return write_private_file(path, written.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

}  // namespace hw
