#pragma once
// What a rehearsal hears of a board: each thing at its own time, be it that it lasts no time at all.
#include <cstdint>
#include <vector>

#include "core/time/clock.h"

namespace hw::vme58 {

struct Note {
  enum class What : std::uint8_t {
    moves,     ///< the axis leaves rest
    rests,     ///< it has come to rest
    done,      ///< its done flag was set
    limit,     ///< it met a limit switch, `on`: the plus one
    looks,     ///< a command waits or goes on by what a line says: `on` is low
    line,      ///< a general line was switched: `on` is low
    aux,       ///< the auxiliary output of the axis was switched: `on` is high
    rejected,  ///< a command error
    restarts,  ///< RS, or power: everything is as from the factory
  };
  What what;
  Instant at;
  int number = 0;             ///< of the axis or the line
  std::int64_t position = 0;  ///< of the axis
  bool on = false;
  int source = 0;  ///< of the command that was done last
};

struct Notes {
  int source = 0;  ///< where the text that is being put into the ring comes
                   ///< from; each command remembers it
  std::vector<Note> list;
};

}  // namespace hw::vme58
