#pragma once
// A guard of the held jogs that runs in the controller itself: it stops them when nobody has spoken to the
// controller for a while.
#include <chrono>
#include <cstdint>
#include <string>

namespace hw {

/// As it is offered: each a sentence or two.
struct JogGuardFacts {
  std::string what;   ///< it does; empty: the controller can run none
  std::string where;  ///< it is kept, and what installing it costs
  std::string doubt;  ///< what only real hardware can show
  [[nodiscard]] bool offered() const { return !what.empty(); }
};

struct JogGuard {
  enum class State : std::uint8_t {
    unknown,
    absent,   ///< there is room for it
    no_room,  ///< the program memory holds something else
    installed
  };
  State state = State::unknown;
  std::chrono::milliseconds silence{};  ///< after which it stops a held jog; of one that is installed
  bool operator==(const JogGuard&) const = default;
};

}  // namespace hw
