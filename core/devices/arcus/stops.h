#pragma once
// Stopping, by decision AMB-128: STOP (or ABORT), a stop of every program, STOP again because one may have
// begun a move in between, the joystick off if it is on. Then the status, until all axes stand.
#include <string>

#include "core/devices/arcus/motion_status.h"
#include "core/devices/arcus/threads.h"

namespace hw::arcus {

class Stops {
 public:
  Stops(const Console& console, Conversation& conversation, CodeAtWork& code, SetUp& setup, MoveList& list,
        Motions& motions, MotionStatus& status, Threads& threads)
      : console_(console),
        conversation_(conversation),
        code_(code),
        setup_(setup),
        list_(list),
        motions_(motions),
        status_(status),
        threads_(threads) {}

  /// All stops except the user's own texts.
  Task<Result<>> stop(const StopOrder& order);
  /// Reads whether the controller stands.
  Task<Result<>> look();
  [[nodiscard]] LastWill last_will(unsigned axes) const;
  StopProgress progress(const StopOrder& order);

 private:
  Task<Result<>> send(const StopOrder& order, Duration patience);
  Task<Result<>> stop_line(bool at_once);
  Task<Result<>> stop_axes(const StopOrder& order, Duration patience);
  Task<Result<>> stop_all(std::string word, Duration patience);
  Task<Result<>> halt_thread(int thread, Duration patience);
  Task<Result<>> halt_program(int thread, Duration patience);
  Task<Result<>> release_joystick(int axis, std::string stop);
  [[nodiscard]] StopProgress programs_end(const StopOrder& order) const;

  const Console& console_;
  Conversation& conversation_;
  CodeAtWork& code_;
  SetUp& setup_;
  MoveList& list_;
  Motions& motions_;
  MotionStatus& status_;
  Threads& threads_;
  bool halting_ = false;  ///< programs are being ended: their state is read while axes stop
};

}  // namespace hw::arcus
