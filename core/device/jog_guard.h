#pragma once
// A guard program in the controller itself, which stops held jogs when the controller has not been addressed
// for a while.
#include <chrono>
#include <cstdint>
#include <string>

namespace hw {

/// The texts of the offer: a sentence or two each.
struct JogGuardFacts {
  std::string what;   ///< what the guard does; empty: the controller cannot run one
  std::string where;  ///< where it is kept, and the cost of installing it
  std::string doubt;  ///< what only a test on real hardware can confirm
  [[nodiscard]] bool offered() const { return !what.empty(); }
};

struct JogGuard {
  enum class State : std::uint8_t {
    unknown,
    absent,   ///< it is not installed, and there is room
    no_room,  ///< the program memory holds another program
    installed
  };
  State state = State::unknown;
  std::chrono::milliseconds silence{};  ///< silence after which it stops a held jog, if installed
  bool operator==(const JogGuard&) const = default;
};

}  // namespace hw
