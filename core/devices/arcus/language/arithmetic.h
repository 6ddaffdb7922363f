#pragma once
// 32-bit two's complement with wrap; C's division; shifts by the count's low five bits (AMB-121).
#include <cstdint>
#include <optional>

#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {

/// None: division by zero.
[[nodiscard]] constexpr std::optional<std::int32_t> compute(Operator operation, std::int32_t a,
                                                            std::int32_t b) {
  const auto ua = static_cast<std::uint32_t>(a), ub = static_cast<std::uint32_t>(b);
  const auto wrapped = [](std::uint64_t n) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(n));
  };
  switch (operation) {
    case Operator::add: return wrapped(ua + ub);
    case Operator::subtract: return wrapped(ua - ub);
    case Operator::multiply: return wrapped(std::uint64_t{ua} * ub);
    case Operator::divide:
      if (b == 0) return std::nullopt;
      return b == -1 ? wrapped(0U - ua) : a / b;
    case Operator::remainder:
      if (b == 0) return std::nullopt;
      return b == -1 ? 0 : a % b;
    case Operator::shift_right: return a >> (ub & 31);
    case Operator::shift_left: return wrapped(ua << (ub & 31));
    case Operator::bit_and: return a & b;
    case Operator::bit_or: return a | b;
    case Operator::copy: return a;
    case Operator::complement: return ~a;
  }
  return std::nullopt;
}

[[nodiscard]] constexpr bool holds(Comparison comparison, std::int32_t a, std::int32_t b) {
  switch (comparison) {
    case Comparison::equal: return a == b;
    case Comparison::greater: return a > b;
    case Comparison::less: return a < b;
    case Comparison::greater_or_equal: return a >= b;
    case Comparison::less_or_equal: return a <= b;
    case Comparison::not_equal: return a != b;
  }
  return false;
}

}  // namespace hw::arcus::language
