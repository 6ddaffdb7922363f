#pragma once
// Events of a board for a rehearsal, each at its own time, even those that take no time.
#include <cstdint>
#include <vector>

#include "core/time/clock.h"

namespace hw::vme58 {

struct Note {
  enum class What : std::uint8_t {
    moves,     ///< the axis leaves rest
    rests,     ///< the axis has come to rest
    done,      ///< its done flag was set
    limit,     ///< the axis met a limit switch, `on`: the plus one
    looks,     ///< a command depends on a line and reads it: `on` is low
    line,      ///< a general line was switched: `on` is low
    aux,       ///< the auxiliary output of the axis was switched: `on` is high
    rejected,  ///< a command error
    restarts,  ///< RS or power-up: everything is in factory state
  };
  What what;
  Instant at;
  int number = 0;             ///< of the axis or the line
  std::int64_t position = 0;  ///< of the axis
  bool on = false;
  int source = 0;  ///< of the last command carried out
};

struct Notes {
  int source = 0;  ///< source of the text now put into the ring; kept by each command
  std::vector<Note> list;
};

}  // namespace hw::vme58
