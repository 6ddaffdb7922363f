#pragma once
// Asking where the axes are and what they do: four questions, each answered for all axes, and StepNLoop of
// those that have it on.
#include <string_view>
#include <vector>

#include "core/devices/arcus/motions.h"
#include "core/devices/arcus/move_list.h"
#include "core/devices/arcus/readouts.h"
#include "core/devices/arcus/second_look.h"

namespace hw::arcus {

class MotionStatus {
 public:
  MotionStatus(const Console& console, Conversation& talk, CodeAtWork& code, MoveList& list,
               Readouts& readouts, RestartWatch& watch, Motions& motions)
      : console_(console),
        talk_(talk),
        code_(code),
        list_(list),
        readouts_(readouts),
        watch_(watch),
        motions_(motions) {}

  /// Each is looked at for a restart: one that was not would hide it from the next.
  Task<Result<>> read(Priority priority);
  /// Without that look.
  Task<Result<>> read_whole(Priority priority);
  Task<Result<>> read_loops(Priority priority);
  /// What is said when no clear answer came to something that moves.
  Task<Fault> after_doubt(Fault why, std::string_view sent);
  [[nodiscard]] Instant round_began() const { return round_began_; }

 private:
  Task<Result<>> read_counters(Priority priority);
  void take_status(const std::vector<std::int64_t>& words);

  const Console& console_;
  Conversation& talk_;
  CodeAtWork& code_;
  MoveList& list_;
  Readouts& readouts_;
  RestartWatch& watch_;
  Motions& motions_;
  SecondLook limits_look_;
  Instant round_began_{};
  Instant asked_at_{};  ///< the oldest question of the newest round that has been applied
};

}  // namespace hw::arcus
