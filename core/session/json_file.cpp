#include "core/session/json_file.h"

#include <nlohmann/json.hpp>

#include <fmt/core.h>

#include "core/session/user_files.h"

namespace hw {

using nlohmann::json;

Fault damaged(const std::filesystem::path& path, std::string_view what_it_is) {
  const auto aside = set_aside(path);
  return Fault(FaultKind::text, fmt::format("The file with {} is damaged ({}).", what_it_is, path.string()),
               aside.empty()
                   ? "It was left as it is and is not used."
                   : fmt::format("It was renamed to {}, and a new one begins.", aside.filename().string()));
}

Result<json> read_json(const std::filesystem::path& path, std::string_view what_it_is) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return json::object();
  constexpr std::uintmax_t largest = 16'000'000;
  auto bytes = read_file(path, largest);
  if (!bytes) return fail(bytes.error());
  json object = json::parse(*bytes, nullptr, false);
  if (object.is_discarded() || !object.is_object()) return fail(damaged(path, what_it_is));
  return object;
}

Result<> write_json(const std::filesystem::path& path, const json& object) {
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  return write_file(path, object.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

}  // namespace hw
