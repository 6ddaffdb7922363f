#pragma once
// Turns requests into legs: moves, jogs, homing, zero, outputs.
#include <vector>

#include "core/devices/vxm/admission.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/identification.h"
#include "core/devices/vxm/job.h"
#include "core/devices/vxm/legs.h"
#include "core/devices/vxm/parameters.h"
#include "core/devices/vxm/positions.h"
#include "core/devices/vxm/signals.h"
#include "core/devices/vxm/speeds.h"

namespace hw::vxm {

class Moves {
 public:
  Moves(const Console& console, Conversation& conversation, const Identification& identification,
        Signals& signals, const Parameters& setup, const Speeds& speeds, Admission& admission,
        Positions& positions, Legs& legs)
      : console_(console),
        conversation_(conversation),
        identification_(identification),
        signals_(signals),
        parameters_(setup),
        speeds_(speeds),
        admission_(admission),
        positions_(positions),
        legs_(legs) {}

  /// `own`: speeds of single motors, which move one after another.
  Task<Result<>> move(const std::vector<AxisTarget>& targets, intent::Pace pace,
                      const intent::AxisSpeeds& own, bool relative);
  Task<Result<>> jog(const intent::JogStart& request);
  Task<Result<>> home(const intent::Home& request);
  Task<Result<>> set_position(const intent::SetPosition& request);
  Task<Result<>> set_output(const intent::SetOutput& request);

 private:
  [[nodiscard]] Result<> may_move_all(const std::vector<AxisTarget>& targets, bool relative) const;
  Result<std::vector<AxisTarget>> checked_goals(const std::vector<AxisTarget>& targets, bool relative);
  void add_leg(Job& job, const AxisTarget& goal, LegPace pace, bool relative) const;

  const Console& console_;
  Conversation& conversation_;
  const Identification& identification_;
  Signals& signals_;
  const Parameters& parameters_;
  const Speeds& speeds_;
  Admission& admission_;
  Positions& positions_;
  Legs& legs_;
};

}  // namespace hw::vxm
