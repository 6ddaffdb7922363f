#pragma once
// Axes, inputs and slots are counted as int where a protocol or a person names them, and index as
// std::size_t.
#include <cstddef>

namespace hw {

constexpr std::size_t ix(int index) { return static_cast<std::size_t>(index); }

}  // namespace hw
