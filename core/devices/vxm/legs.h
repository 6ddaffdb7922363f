#pragma once
// Carries out a move of the console: each leg is a run of the scratch program.
#include <optional>
#include <string>

#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/hold_switch.h"
#include "core/devices/vxm/job.h"
#include "core/devices/vxm/knowledge.h"
#include "core/devices/vxm/positions.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/ramp.h"
#include "core/devices/vxm/scratch.h"
#include "core/devices/vxm/signals.h"
#include "core/devices/vxm/slots.h"
#include "core/devices/vxm/speeds.h"
#include "core/devices/vxm/status.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class Legs {
 public:
  Legs(const Console& console, Conversation& conversation, Signals& signals, Slots& slots, Scratch& scratch,
       Speeds& speeds, Hold& hold, HoldSwitch& hold_switch, Knowledge& knowledge, const Presence& presence,
       UnderWay& under_way, Ramp& ramp, Positions& positions, Status& status)
      : console_(console),
        conversation_(conversation),
        signals_(signals),
        slots_(slots),
        scratch_(scratch),
        speeds_(speeds),
        hold_(hold),
        hold_switch_(hold_switch),
        knowledge_(knowledge),
        presence_(presence),
        under_way_(under_way),
        ramp_(ramp),
        positions_(positions),
        status_(status) {}

  Task<Result<>> begin(Job job);
  /// Runs a leg that is over at once, and waits for its end.
  Task<Result<>> run_quickly(Leg leg);
  /// Does the work that is due before anything else: switches off a hold that was left on, starts the leg
  /// after one that is over, and removes the console's program from the controller when nothing runs.
  Task<Result<>> settle();
  /// Reads where the leg ended.
  Task<Result<>> end_leg(Priority priority);
  void show_leg(const Leg& leg);
  /// Restores the speeds left by a leg that was cut off.
  Task<Result<>> restore_speeds();
  /// `up_to`: end of the travel; none: end of the position register.
  [[nodiscard]] Leg jog_leg(int axis, Sign sign, LegPace pace, std::optional<Steps> up_to) const;

  // ---- see Driver
  [[nodiscard]] bool clears_up() const;
  [[nodiscard]] std::string leaves_behind() const;

 private:
  Task<Result<>> start_leg();
  Result<> never_begun(const Result<>& why);
  [[nodiscard]] Result<> cut_short() const;
  [[nodiscard]] std::string leg_program(const Leg& leg) const;
  [[nodiscard]] EndedBy end_of_leg(const Leg& leg) const;
  [[nodiscard]] std::string program_left_behind() const;
  [[nodiscard]] double ramp_of(const Leg& leg, int axis) const;
  void show_leg_ended(const Leg& leg, EndedBy ended_by);
  [[nodiscard]] std::optional<Leg> next_jog_leg(const Leg& last, EndedBy ended_by) const;

  const Console& console_;
  Conversation& conversation_;
  Signals& signals_;
  Slots& slots_;
  Scratch& scratch_;
  Speeds& speeds_;
  Hold& hold_;
  HoldSwitch& hold_switch_;
  Knowledge& knowledge_;
  const Presence& presence_;
  UnderWay& under_way_;
  Ramp& ramp_;
  Positions& positions_;
  Status& status_;
};

}  // namespace hw::vxm
