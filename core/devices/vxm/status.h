#pragma once
// Handles the reply to V, which is answered at once in every mode.
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/restarts.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class Status {
 public:
  Status(const Console& console, Conversation& conversation, Presence& presence, Hold& hold,
         UnderWay& under_way, Restarts& restarts)
      : console_(console),
        conversation_(conversation),
        presence_(presence),
        hold_(hold),
        under_way_(under_way),
        restarts_(restarts) {}

  Task<Result<>> take(char state);
  /// Call before a request, which must not hide an unseen restart: replies to questions that clean the line
  /// are not handled.
  Task<Result<>> clean_if_dirty();
  /// After its error report the controller answers nothing but K. If it answers V, it was switched off and
  /// on, or received a K from elsewhere.
  Task<Result<>> ask_again_while_silent();

 private:
  const Console& console_;
  Conversation& conversation_;
  Presence& presence_;
  Hold& hold_;
  UnderWay& under_way_;
  Restarts& restarts_;
};

}  // namespace hw::vxm
