#pragma once
// One status round. In motion: positions, and whether the program or move still runs, as often as the wire
// allows. At rest: everything, five times a second.
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/echo.h"
#include "core/devices/vxm/headline.h"
#include "core/devices/vxm/identification.h"
#include "core/devices/vxm/knowledge.h"
#include "core/devices/vxm/legs.h"
#include "core/devices/vxm/positions.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/runs.h"
#include "core/devices/vxm/signals.h"
#include "core/devices/vxm/status.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class StatusRounds {
 public:
  StatusRounds(const Console& console, Conversation& conversation, const Identification& identification,
               Signals& signals, Knowledge& knowledge, Presence& presence, const UnderWay& under_way,
               Positions& positions, const Headline& headline, Status& status, Echo& echo, Legs& legs,
               Runs& runs)
      : console_(console),
        conversation_(conversation),
        identification_(identification),
        signals_(signals),
        knowledge_(knowledge),
        presence_(presence),
        under_way_(under_way),
        positions_(positions),
        headline_(headline),
        status_(status),
        echo_(echo),
        legs_(legs),
        runs_(runs) {}

  Task<Result<>> poll(Round round);
  [[nodiscard]] Duration moving_period() const;

 private:
  Task<Result<>> poll_on_line(Round round);
  Task<Result<>> poll_echoing();
  Task<Result<>> see_whether_it_stands();
  Task<Result<>> poll_local();

  const Console& console_;
  Conversation& conversation_;
  const Identification& identification_;
  Signals& signals_;
  Knowledge& knowledge_;
  Presence& presence_;
  const UnderWay& under_way_;
  Positions& positions_;
  const Headline& headline_;
  Status& status_;
  Echo& echo_;
  Legs& legs_;
  Runs& runs_;
  int round_ = 0;
  Instant round_began_{};
};

}  // namespace hw::vxm
