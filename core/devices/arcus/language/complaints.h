#pragma once
// Messages about a word that the language does not know.
#include <cstdint>
#include <string>
#include <string_view>

#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus::language {

struct Complaint {
  std::string sentence;
  std::string fix;  ///< what the word should be, or empty
};

/// `word`: letters in capitals and the digits behind them, as one.
[[nodiscard]] Complaint unknown_word(const Dialect& dialect, std::string_view word);

/// "DO takes 0 to 255."
[[nodiscard]] std::string value_range(const NameRow& row, const std::string& name);
[[nodiscard]] std::string position_range(const Dialect& dialect);

[[nodiscard]] std::string grouped(std::int64_t number);  ///< 6,000,000

}  // namespace hw::arcus::language
