#pragma once
// Lengths by definition.

namespace hw {

inline constexpr double mm_per_inch = 25.4;

}  // namespace hw
