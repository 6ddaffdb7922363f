#pragma once
// Numbers that know what they count. Kinds do not mix; `.value` gives the bare number.
#include <compare>
#include <cstdint>

namespace hw {

template <class Tag, class Rep>
struct Quantity {
  Rep value{};

  constexpr Quantity() = default;
  constexpr explicit Quantity(Rep v) : value(v) {}

  constexpr auto operator<=>(const Quantity&) const = default;
  constexpr Quantity operator-() const { return Quantity(-value); }
  constexpr Quantity& operator+=(Quantity o) { return value += o.value, *this; }
  constexpr Quantity& operator-=(Quantity o) { return value -= o.value, *this; }
  friend constexpr Quantity operator+(Quantity a, Quantity b) { return Quantity(a.value + b.value); }
  friend constexpr Quantity operator-(Quantity a, Quantity b) { return Quantity(a.value - b.value); }
};

/// A position or distance in the controller's own unit: motor steps, pulses or encoder counts.
using Steps = Quantity<struct StepsTag, std::int64_t>;
/// 2^53 steps. As a double, a larger number may stand for several neighbouring steps.
inline constexpr double countable = 9'007'199'254'740'992;
/// A speed in steps (pulses, counts) per second. Never negative where a direction is given beside it.
using Pps = Quantity<struct PpsTag, double>;

enum class Sign : std::int8_t { minus = -1, plus = 1 };
constexpr Sign operator-(Sign s) { return s == Sign::plus ? Sign::minus : Sign::plus; }
constexpr std::int64_t factor(Sign s) { return static_cast<std::int64_t>(s); }
constexpr char letter(Sign s) { return s == Sign::plus ? '+' : '-'; }

/// Place of an axis in its catalog, from 0. The maker's name for it ("1", "X") stands in the catalog.
struct AxisId {
  std::uint8_t index = 0;
  constexpr auto operator<=>(const AxisId&) const = default;
};

inline constexpr int max_axes = 8;

}  // namespace hw
