#pragma once
// Status during a long procedure, so that the display does not go stale.
#include "core/devices/arcus/motion_status.h"
#include "core/devices/arcus/threads.h"

namespace hw::arcus {

/// Time between status rounds.
inline constexpr Duration period_at_rest = Millis(200);

class LiveStatus {
 public:
  LiveStatus(const Console& console, Conversation& conversation, MotionStatus& status, Threads& threads)
      : console_(console), conversation_(conversation), status_(status), threads_(threads) {}

  /// Reads the status if a round is due.
  Task<> read();

 private:
  const Console& console_;
  Conversation& conversation_;
  MotionStatus& status_;
  Threads& threads_;
};

}  // namespace hw::arcus
