#pragma once
// The words that low-level lines use for comparisons and operators.
#include <optional>
#include <string_view>

#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {

[[nodiscard]] std::string_view comparison_code(Comparison comparison);    ///< "EQ"
[[nodiscard]] std::string_view comparison_symbol(Comparison comparison);  ///< "="
[[nodiscard]] std::string_view operator_code(Operator operation);         ///< "ADD"
[[nodiscard]] std::string_view operator_symbol(Operator operation);       ///< "+"
[[nodiscard]] std::optional<Comparison> comparison_from_code(std::string_view code);
[[nodiscard]] std::optional<Comparison> comparison_from_symbol(std::string_view symbol);
[[nodiscard]] std::optional<Operator> operator_from_code(std::string_view code);
[[nodiscard]] std::optional<Operator> operator_from_symbol(std::string_view symbol);
[[nodiscard]] constexpr bool has_two_operands(Operator o) {
  return o != Operator::copy && o != Operator::complement;
}

}  // namespace hw::arcus::language
