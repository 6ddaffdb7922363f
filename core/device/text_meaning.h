#pragma once
// The effects of a raw text that the pump must know before it sends the text. Each family interprets its own
// texts, once, by a pure function.
#include <cstdint>

namespace hw {

struct TextMeaning {
  enum class Stops : std::uint8_t { nothing, some, all };
  enum class Answered : std::uint8_t {
    at_once,
    later,  ///< answered by a prompt when the action that it began is over
    never
  };
  /// The addressee, on a shared wire.
  enum class For : std::uint8_t {
    this_one,
    another,  ///< the device at `address`
    all
  };

  Stops stops = Stops::nothing;
  int axis = -1;           ///< the axis that it stops; -1: several, or none
  std::uint32_t axes = 0;  ///< bit per axis that it may stop, if not all; none for a program
  Answered answered = Answered::at_once;
  bool end_is_reported = false;  ///< the controller reports the end of what it began
  bool changes_programs = false;
  bool runs_program = false;  ///< starts a stored program, or continues one
  bool restarts = false;      ///< the controller restarts
  bool only_asks = false;     ///< it changes nothing in the controller and moves nothing
  For addressee = For::this_one;
  int address = -1;

  [[nodiscard]] bool is_stop() const { return stops != Stops::nothing; }
  [[nodiscard]] bool stops_here() const { return is_stop() && addressee != For::another; }
};

}  // namespace hw
