#pragma once
// The places to which a raw text sends the axes, as far as the text names them. The user is warned if they
// lie past a limit. Each family reads its own texts.
#include <vector>

#include "core/device/intent.h"

namespace hw {

/// Empty for a text that is not understood, or whose places depend on unknown values.
struct TextGoals {
  /// Absolute, in the order of the text; `without_end` for a motion that nothing in it ends.
  std::vector<AxisTarget> places{};
  /// The stored program that it starts, unless `places` hold those of the program too; -1: none.
  int runs = -1;
};

/// Commands of one text that are followed, those of loops and of stored programs as often as they run.
inline constexpr int most_goal_commands = 20'000;

}  // namespace hw
