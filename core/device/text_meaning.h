#pragma once
// What the pump must know of a raw text before it is sent. Each family reads its own texts, once, by a pure
// function.
#include <cstdint>

namespace hw {

struct TextMeaning {
  enum class Stops : std::uint8_t { nothing, some, all };
  enum class Answered : std::uint8_t {
    at_once,
    later,  ///< by a prompt, when what it began is over
    never
  };
  /// Whom it is for, on a wire that several controllers share.
  enum class For : std::uint8_t {
    this_one,
    another,  ///< the device at `address`
    everybody
  };

  Stops stops = Stops::nothing;
  int axis = -1;           ///< that it stops; -1: several, or none
  std::uint32_t axes = 0;  ///< bit per axis that it may stop, where it does not stop all; of a program none
  Answered answered = Answered::at_once;
  bool end_is_told = false;  ///< the controller tells by itself when what it began is over
  bool changes_programs = false;
  bool runs_program = false;  ///< starts a stored one, or lets one go on
  bool restarts = false;      ///< the controller begins anew
  For whom = For::this_one;
  int address = -1;

  [[nodiscard]] bool is_stop() const { return stops != Stops::nothing; }
  [[nodiscard]] bool stops_here() const { return is_stop() && whom != For::another; }
};

}  // namespace hw
