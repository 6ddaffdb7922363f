#pragma once
// What V tells: it is answered in every mode, and at once.
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/restarts.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class Status {
 public:
  Status(const Console& console, Conversation& talk, Presence& presence, Hold& hold, UnderWay& under_way,
         Restarts& restarts)
      : console_(console),
        talk_(talk),
        presence_(presence),
        hold_(hold),
        under_way_(under_way),
        restarts_(restarts) {}

  Task<Result<>> take(char state);
  /// What is to be done next must not hide a restart that went unseen: what is asked to clean the line tells
  /// nobody.
  Task<Result<>> see_to_dirt();
  /// After its error report it answers nothing but K. What answers was switched off and on, or somebody
  /// else's K has reached it.
  Task<Result<>> ask_whether_it_hears_again();

 private:
  const Console& console_;
  Conversation& talk_;
  Presence& presence_;
  Hold& hold_;
  UnderWay& under_way_;
  Restarts& restarts_;
};

}  // namespace hw::vxm
