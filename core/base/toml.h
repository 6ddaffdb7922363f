#pragma once
// The only access to toml++: declarations only. The parser is compiled once, in toml.cpp (in two files it
// took 20 s of every build).
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 0
#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace hw {

/// toml++ under its usual name, except that endless nesting, lines of megabytes and names that are not text
/// are refused as a fault of that line (toml_guard.cpp).
namespace toml {
using namespace ::toml;
::toml::parse_result parse(std::string_view text);
}  // namespace toml

/// Formats a text as a value in quotation marks, on one line.
std::string toml_quoted(std::string_view text);
/// The same over several lines, unchanged.
std::string toml_lines(std::string_view text);
/// Formats a key, in quotation marks if necessary.
std::string toml_key(std::string_view name);

}  // namespace hw
