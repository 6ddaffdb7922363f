#pragma once
// The catalog's actions.
#include "core/devices/vme58/moves.h"
#include "core/devices/vme58/servo_drive.h"

namespace hw::vme58 {

class Actions {
 public:
  Actions(const Selection& selection, Commands& commands, ServoLoops& loops, ServoDrive& drive,
          Motions& motions, Moves& moves, Speeds& speeds, NextRound& next, const Catalog& catalog,
          Snapshot& snapshot)
      : selection_(selection),
        commands_(commands),
        loops_(loops),
        drive_(drive),
        motions_(motions),
        moves_(moves),
        speeds_(speeds),
        next_(next),
        catalog_(catalog),
        snapshot_(snapshot) {}

  Task<Result<>> act(intent::Act request);

 private:
  void clear_flags();

  const Selection& selection_;
  Commands& commands_;
  ServoLoops& loops_;
  ServoDrive& drive_;
  Motions& motions_;
  Moves& moves_;
  Speeds& speeds_;
  NextRound& next_;
  const Catalog& catalog_;
  Snapshot& snapshot_;
};

}  // namespace hw::vme58
