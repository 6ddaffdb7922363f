#pragma once
// Status in the middle of a long procedure: what is shown must not grow stale meanwhile.
#include "core/devices/arcus/motion_status.h"
#include "core/devices/arcus/threads.h"

namespace hw::arcus {

/// From one round of status to the next.
inline constexpr Duration period_at_rest = Millis(200);

class LiveStatus {
 public:
  LiveStatus(const Console& console, Conversation& talk, MotionStatus& status, Threads& threads)
      : console_(console), talk_(talk), status_(status), threads_(threads) {}

  /// If it is time.
  Task<> read();

 private:
  const Console& console_;
  Conversation& talk_;
  MotionStatus& status_;
  Threads& threads_;
};

}  // namespace hw::arcus
