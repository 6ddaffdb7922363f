#pragma once
// Switches the hold by H, and makes its state known again by K.
#include <string>

#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/kills.h"

namespace hw::vxm {

class HoldSwitch {
 public:
  HoldSwitch(Conversation& conversation, Hold& hold, Kills& kills)
      : conversation_(conversation), hold_(hold), kills_(kills) {}

  /// Refuses while another H might switch the hold either way.
  [[nodiscard]] Result<> may_switch() const;
  /// Sends `text`, after which the hold is on, or off. H toggles: include it only where the hold must change.
  Task<Result<>> transmit(std::string text, bool on, Priority priority);
  /// A hold left on keeps a move of the console from beginning: nothing turns.
  [[nodiscard]] bool keeps_our_move() const { return hold_.is_to_be_released(); }
  /// Call before any run: makes the state of the hold known.
  Task<Result<>> settle();

 private:
  Conversation& conversation_;
  Hold& hold_;
  Kills& kills_;
};

}  // namespace hw::vxm
