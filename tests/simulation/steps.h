#pragma once
// The table of verbs: everything that can be done to a controller, to what surrounds it and to its wire.
#include <span>
#include <string_view>

#include "tests/simulation/plan.h"

namespace hw::simulation {

class Stage;

struct Verb {
  enum class Kind : std::uint8_t { action, stop, bench, fault };
  std::string_view name;
  std::size_t numbers;  ///< of its step
  Kind kind;
  void (*perform)(Stage& stage, const Step& step);
  bool moves = false;  ///< once: its numbers are none of the controller's set-up
};

/// What an operator does: steps_operator.cpp.
std::span<const Verb> operator_verbs();
/// What happens to the machine and to the wire: steps_world.cpp.
std::span<const Verb> world_verbs();

const Verb* find_verb(std::string_view name);

}  // namespace hw::simulation
