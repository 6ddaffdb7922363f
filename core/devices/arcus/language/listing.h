#pragma once
// The low-level lines of a program as a text file, and back (LISTING.md).
#include <string>
#include <string_view>
#include <vector>

#include "core/device/language.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus::language {

[[nodiscard]] std::string write_listing(const std::vector<std::string>& lines, const Dialect& dialect);

struct ReadListing {
  std::vector<std::string> lines;
  std::vector<int> source_line;  ///< for each of them the line of the text
  std::vector<Problem> problems;
};
/// Whether a text is meant as a listing: its first word, after comments and blank lines, is LISTING.
[[nodiscard]] bool is_listing(std::string_view text);
[[nodiscard]] ReadListing read_listing(std::string_view text, const Dialect& dialect);

}  // namespace hw::arcus::language
