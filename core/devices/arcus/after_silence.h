#pragma once
// Where an answer was missing since the last look, whatever goes out next might hide a restart: an axis that
// moves does not stand at zero. So it is looked at first.
#include "core/devices/arcus/lines.h"
#include "core/devices/arcus/motion_status.h"
#include "core/devices/arcus/threads.h"

namespace hw::arcus {

class AfterSilence {
 public:
  AfterSilence(const Console& console, RestartWatch& watch, MotionStatus& status, Threads& threads,
               Lines& lines)
      : console_(console), watch_(watch), status_(status), threads_(threads), lines_(lines) {}

  /// Before anything goes out. What was asked for meant the controller as it was before.
  Task<Result<>> look();
  /// When the wire has come back and the state was read.
  Task<Result<>> look_back_over_the_loss();

 private:
  const Console& console_;
  RestartWatch& watch_;
  MotionStatus& status_;
  Threads& threads_;
  Lines& lines_;
};

}  // namespace hw::arcus
