#pragma once
// Runs a list of moves: the axes follow it, and each status round feeds it.
#include "core/devices/arcus/motion_status.h"

namespace hw::arcus {

class Feed {
 public:
  Feed(const Console& console, MoveList& list, Motions& motions, MotionStatus& status)
      : console_(console), list_(list), motions_(motions), status_(status) {}

  Task<Result<>> start(intent::FeedMoves request);
  /// Sends as many moves as the buffer has places for.
  Task<Result<>> go_on();

 private:
  const Console& console_;
  MoveList& list_;
  Motions& motions_;
  MotionStatus& status_;
};

}  // namespace hw::arcus
