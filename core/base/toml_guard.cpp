// toml++ makes a table for every part of a name and destroys them recursively. So endless nesting is refused
// before a file is read.
#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/base/toml.h"

namespace hw {
namespace {

constexpr int deepest_value = 128, most_parts_of_a_name = 16;
constexpr std::size_t longest_line = 1'000'000, longest_toml_name = 200;

/// Counts brackets and the parts of names outside of strings and comments.
class NestingScan {
 public:
  explicit NestingScan(std::string_view text) : text_(text) {}
  /// Empty: the file may be read. Else the reason; its place is at().
  std::string_view problem() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'')
        pass_string(c);
      else if (c == '#')
        at_ = std::min(text_.find('\n', at_), text_.size());
      else
        count(c);
      if (depth_ > deepest_value) return "it is nested too deep";
      if (dots_ >= most_parts_of_a_name) return "a name has too many parts";
    }
    return {};
  }
  [[nodiscard]] std::size_t at() const { return at_; }

 private:
  void count(char c) {
    ++at_;
    if (c == '.') {
      ++dots_;
      return;
    }
    const bool opens = c == '[' || c == '{', closes = c == ']' || c == '}';
    if (opens) ++depth_;
    if (closes) depth_ = std::max(0, depth_ - 1);
    if (opens || closes || c == ',' || c == '=' || c == '\n') dots_ = 0;
  }
  void pass_string(char quote) {
    const char three[] = {quote, quote, quote};
    const bool lines = text_.substr(at_, 3) == std::string_view(three, 3);
    at_ += lines ? 3 : 1;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\\' && quote == '"') {
        at_ = std::min(at_ + 2, text_.size());
        continue;
      }
      if (lines ? text_.substr(at_, 3) == std::string_view(three, 3) : c == quote) break;
      if (!lines && c == '\n') return;
      ++at_;
    }
    at_ = std::min(at_ + (lines ? 3 : 1), text_.size());
    // Up to two quotation marks of the text may stand before the three that end it.
    for (int more = 0; lines && more < 2 && at_ < text_.size() && text_[at_] == quote; ++more) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0, dots_ = 0;
};

::toml::parse_result toml_refused(std::string_view why, ::toml::source_position at) {
  return ::toml::parse_result(::toml::parse_error(std::string(why), at));
}

::toml::source_position line_at(std::string_view text, std::size_t at) {
  const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  return {static_cast<::toml::source_index>(lines + 1), 1};
}

/// Where a line that is too long begins; npos: none.
std::size_t too_long_a_line(std::string_view text) {
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    if (end - from > longest_line) return from;
    from = end + 1;
  }
  return std::string_view::npos;
}

bool is_a_name(std::string_view name) {
  return name.size() <= longest_toml_name && std::none_of(name.begin(), name.end(), [](char c) {
           return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
         });
}

/// The first name that cannot be shown in a sentence or on a screen.
std::optional<::toml::source_position> bad_name(const ::toml::node& node) {
  if (const ::toml::array* array = node.as_array())
    for (const ::toml::node& part : *array)
      if (const auto bad = bad_name(part)) return bad;
  if (const ::toml::table* table = node.as_table())
    for (const auto& [key, value] : *table) {
      if (!is_a_name(key.str())) return key.source().begin;
      if (const auto bad = bad_name(value)) return bad;
    }
  return {};
}

}  // namespace

::toml::parse_result toml::parse(std::string_view text) {
  if (const std::size_t at = too_long_a_line(text); at != text.npos)
    return toml_refused("the line is too long", line_at(text, at));
  NestingScan scan(text);
  if (const std::string_view why = scan.problem(); !why.empty())
    return toml_refused(why, line_at(text, std::min(scan.at(), text.size())));
  ::toml::parse_result parsed = ::toml::parse(text);
  if (parsed)
    if (const auto bad = bad_name(parsed.table()))
      return toml_refused("a name is too long, or has characters that cannot be shown", *bad);
  return parsed;
}

}  // namespace hw
