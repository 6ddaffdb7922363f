#include "core/devices/arcus/language/encoding.h"

namespace hw::arcus::language {
namespace {

struct Name {
  std::string_view code, symbol;
};
// In the order of the enumerators.
constexpr Name comparisons[] = {{"EQ", "="},  {"GT", ">"},  {"LT", "<"},
                                {"GE", ">="}, {"LE", "<="}, {"NE", "!="}};
constexpr Name operators[] = {{"ADD", "+"}, {"SUB", "-"},  {"MUL", "*"},  {"DIV", "/"},
                              {"MOD", "%"}, {"SHR", ">>"}, {"SHL", "<<"}, {"AND", "&"},
                              {"OR", "|"},  {"PUT", ""},   {"NOT", "~"}};

template <class Enum, std::size_t size>
std::optional<Enum> find(const Name (&names)[size], std::string_view Name::*part, std::string_view text) {
  for (std::size_t i = 0; i < size; ++i)
    if (names[i].*part == text) return static_cast<Enum>(i);
  return std::nullopt;
}

}  // namespace

std::string_view comparison_code(Comparison c) { return comparisons[static_cast<int>(c)].code; }
std::string_view comparison_symbol(Comparison c) { return comparisons[static_cast<int>(c)].symbol; }
std::string_view operator_code(Operator o) { return operators[static_cast<int>(o)].code; }
std::string_view operator_symbol(Operator o) { return operators[static_cast<int>(o)].symbol; }

std::optional<Comparison> comparison_from_code(std::string_view code) {
  return find<Comparison>(comparisons, &Name::code, code);
}
std::optional<Comparison> comparison_from_symbol(std::string_view symbol) {
  return find<Comparison>(comparisons, &Name::symbol, symbol);
}
std::optional<Operator> operator_from_code(std::string_view code) {
  return find<Operator>(operators, &Name::code, code);
}
std::optional<Operator> operator_from_symbol(std::string_view symbol) {
  return find<Operator>(operators, &Name::symbol, symbol);
}

}  // namespace hw::arcus::language
