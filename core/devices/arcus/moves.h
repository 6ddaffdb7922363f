#pragma once
// Moves, jogs, homing, positions. The user's move mode (ABS, INC) is never changed: targets are sent as the
// present mode takes them.
#include <string>
#include <vector>

#include "core/devices/arcus/motion_status.h"

namespace hw::arcus {

class Moves {
 public:
  Moves(const Console& console, Conversation& conversation, const SetUp& setup, BorrowedSetting& borrowed,
        Readouts& readouts, RestartWatch& watch, Motions& motions, MotionStatus& status)
      : console_(console),
        conversation_(conversation),
        setup_(setup),
        borrowed_(borrowed),
        readouts_(readouts),
        watch_(watch),
        motions_(motions),
        status_(status) {}

  Task<Result<>> move(std::vector<AxisTarget> request, intent::Pace pace, bool relative,
                      Activity shown_as = Activity::moving);
  Task<Result<>> jog(intent::JogStart request);
  Task<Result<>> home(intent::Home request);
  Task<Result<>> set_position(intent::SetPosition request);
  Task<Result<>> set_encoder(intent::SetEncoder request);

  /// Sends one command that moves these axes.
  Task<Result<>> start(std::string text, std::vector<int> axes, Activity activity);
  /// Reads the present mode: a program or another terminal may have changed it since the last round.
  Task<Result<bool>> ask_incremental();
  /// Reads the present position of an axis, or its target with StepNLoop.
  Task<Result<std::int64_t>> ask_position(int axis);

 private:
  /// The controller takes its speeds and ramps when a motion begins. `axis` -1: several axes together.
  Task<Result<>> borrow_pace(intent::Pace pace, int axis);
  /// Whether this axis has its own speeds, not those for all axes.
  Task<Result<bool>> has_own_speeds(int axis);
  /// Call after the motion command; a failure does not stop the motion.
  Task<> give_back_pace();

  const Console& console_;
  Conversation& conversation_;
  const SetUp& setup_;
  BorrowedSetting& borrowed_;
  Readouts& readouts_;
  RestartWatch& watch_;
  Motions& motions_;
  MotionStatus& status_;
};

}  // namespace hw::arcus
