#pragma once
// The catalog's actions: commands of these controllers beyond those that all controllers share.
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/devices/arcus/moves.h"

namespace hw::arcus {

class Actions {
 public:
  Actions(const Console& console, Conversation& conversation, SetUp& setup, BorrowedSetting& borrowed,
          MoveList& list, Readouts& readouts, Motions& motions, MotionStatus& status, Moves& moves)
      : console_(console),
        conversation_(conversation),
        setup_(setup),
        borrowed_(borrowed),
        list_(list),
        readouts_(readouts),
        motions_(motions),
        status_(status),
        moves_(moves) {}

  Task<Result<>> act(intent::Act request);

 private:
  Task<Result<>> change_speed(int axis, std::int64_t speed, std::int64_t accel_ms);
  Task<Result<>> change_target(int axis, std::int64_t target);
  Task<Result<>> draw_arc(std::int64_t centre_x, std::int64_t centre_y, std::int64_t sweep);
  Task<Result<>> clear_errors(std::string_view form, int axis);
  Task<Result<>> joystick(int axis, bool on);

  const Console& console_;
  Conversation& conversation_;
  SetUp& setup_;
  BorrowedSetting& borrowed_;
  MoveList& list_;
  Readouts& readouts_;
  Motions& motions_;
  MotionStatus& status_;
  Moves& moves_;
};

}  // namespace hw::arcus
