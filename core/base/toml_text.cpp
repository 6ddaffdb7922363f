#include <cctype>

#include <fmt/core.h>

#include "core/base/toml.h"

namespace hw {
namespace {

std::string escaped(std::string_view text, bool keeps_lines) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      (out += '\\') += c;
    else if (c == '\n' && keeps_lines)
      out += c;
    else if (byte < 0x20 || byte == 0x7F)
      out += fmt::format("\\u{:04X}", byte);
    else
      out += c;
  }
  return out;
}

}  // namespace

std::string toml_quoted(std::string_view text) { return "\"" + escaped(text, false) + "\""; }
std::string toml_lines(std::string_view text) { return "\"\"\"\n" + escaped(text, true) + "\"\"\""; }

std::string toml_key(std::string_view name) {
  for (const char c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') return toml_quoted(name);
  return name.empty() ? "\"\"" : std::string(name);
}

}  // namespace hw
