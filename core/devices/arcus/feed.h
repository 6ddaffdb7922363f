#pragma once
// A list of moves that runs: the axes move by it, and each round of status feeds it.
#include "core/devices/arcus/motion_status.h"

namespace hw::arcus {

class Feed {
 public:
  Feed(const Console& console, MoveList& list, Motions& motions, MotionStatus& status)
      : console_(console), list_(list), motions_(motions), status_(status) {}

  Task<Result<>> start(intent::FeedMoves wish);
  /// As many as there are places for.
  Task<Result<>> go_on();

 private:
  const Console& console_;
  MoveList& list_;
  Motions& motions_;
  MotionStatus& status_;
};

}  // namespace hw::arcus
