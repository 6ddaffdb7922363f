#pragma once
// Moves, jogs, homing, positions. The user's move mode (ABS, INC) is never changed: what is wanted is put the
// way the present mode takes it.
#include <string>
#include <vector>

#include "core/devices/arcus/motion_status.h"

namespace hw::arcus {

class Moves {
 public:
  Moves(const Console& console, Conversation& talk, const SetUp& setup, BorrowedSetting& borrowed,
        Readouts& readouts, RestartWatch& watch, Motions& motions, MotionStatus& status)
      : console_(console),
        talk_(talk),
        setup_(setup),
        borrowed_(borrowed),
        readouts_(readouts),
        watch_(watch),
        motions_(motions),
        status_(status) {}

  Task<Result<>> move(std::vector<AxisTarget> wish, Pps speed, bool relative,
                      Activity shown_as = Activity::moving);
  Task<Result<>> jog(intent::JogStart wish);
  Task<Result<>> home(intent::Home wish);
  Task<Result<>> set_position(intent::SetPosition wish);
  Task<Result<>> set_encoder(intent::SetEncoder wish);

  /// One command that moves these axes.
  Task<Result<>> start(std::string text, std::vector<int> axes, Activity activity);
  /// The mode as it is now: a program or another terminal may have changed it since the last round.
  Task<Result<bool>> ask_incremental();
  /// The same of where an axis stands, or is sent with StepNLoop.
  Task<Result<std::int64_t>> ask_position(int axis);

 private:
  Task<Result<>> borrow_speed(Pps speed, int axis);

  const Console& console_;
  Conversation& talk_;
  const SetUp& setup_;
  BorrowedSetting& borrowed_;
  Readouts& readouts_;
  RestartWatch& watch_;
  Motions& motions_;
  MotionStatus& status_;
};

}  // namespace hw::arcus
