#pragma once
// Brings a controller found on a new wire to a state in which it accepts commands.
#include <string>

#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/echo.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/legs.h"
#include "core/devices/vxm/positions.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/restarts.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class Opening {
 public:
  Opening(const Console& console, Conversation& conversation, Presence& presence, Hold& hold,
          UnderWay& under_way, Positions& positions, Restarts& restarts, Echo& echo, Legs& legs)
      : console_(console),
        conversation_(conversation),
        presence_(presence),
        hold_(hold),
        under_way_(under_way),
        positions_(positions),
        restarts_(restarts),
        echo_(echo),
        legs_(legs) {}

  Task<Result<>> greet();

 private:
  Task<Result<std::string>> ask_for_greeting();
  Task<Result<>> found_local(char state);
  Task<Result<>> resume_after_loss(char state);

  const Console& console_;
  Conversation& conversation_;
  Presence& presence_;
  Hold& hold_;
  UnderWay& under_way_;
  Positions& positions_;
  Restarts& restarts_;
  Echo& echo_;
  Legs& legs_;
};

}  // namespace hw::vxm
