#pragma once
// After a missed reply the next command could hide a restart, because an axis that moves no longer reads
// zero. So the state is read first.
#include "core/devices/arcus/lines.h"
#include "core/devices/arcus/motion_status.h"
#include "core/devices/arcus/threads.h"

namespace hw::arcus {

class AfterSilence {
 public:
  AfterSilence(const Console& console, RestartWatch& watch, MotionStatus& status, Threads& threads,
               Lines& lines)
      : console_(console), watch_(watch), status_(status), threads_(threads), lines_(lines) {}

  /// Call before anything is sent. A fault after a restart: the command was meant for the earlier state.
  Task<Result<>> look();
  /// Call once the wire is back and the state was read.
  Task<Result<>> look_back_over_the_loss();

 private:
  const Console& console_;
  RestartWatch& watch_;
  MotionStatus& status_;
  Threads& threads_;
  Lines& lines_;
};

}  // namespace hw::arcus
