#pragma once
// Reads positions and motion of the axes: four questions, each answered for all axes, and StepNLoop of those
// that have it on.
#include <string_view>
#include <vector>

#include "core/devices/arcus/limit_switches.h"
#include "core/devices/arcus/motions.h"
#include "core/devices/arcus/move_list.h"
#include "core/devices/arcus/readouts.h"

namespace hw::arcus {

class MotionStatus {
 public:
  MotionStatus(const Console& console, Conversation& conversation, CodeAtWork& code, MoveList& list,
               Readouts& readouts, RestartWatch& watch, Motions& motions, LimitSwitches& limits)
      : console_(console),
        conversation_(conversation),
        code_(code),
        list_(list),
        readouts_(readouts),
        watch_(watch),
        motions_(motions),
        limits_(limits) {}

  /// Each reading is checked for a restart: an unchecked one would hide it from the next.
  Task<Result<>> read(Priority priority);
  /// Without that check.
  Task<Result<>> read_whole(Priority priority);
  Task<Result<>> read_loops(Priority priority);
  /// The fault to report when a command that moves had no clear reply.
  Task<Fault> after_doubt(Fault why, std::string_view sent);
  [[nodiscard]] Instant round_began() const { return round_began_; }

 private:
  Task<Result<>> read_counters(Priority priority);
  void take_status(const std::vector<std::int64_t>& words);

  const Console& console_;
  Conversation& conversation_;
  CodeAtWork& code_;
  MoveList& list_;
  Readouts& readouts_;
  RestartWatch& watch_;
  Motions& motions_;
  LimitSwitches& limits_;
  Instant round_began_{};
  Instant asked_at_{};  ///< the oldest question of the newest round applied
};

}  // namespace hw::arcus
