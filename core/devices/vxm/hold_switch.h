#pragma once
// Switching the hold by H, and getting to know it again by K.
#include <string>

#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/kills.h"

namespace hw::vxm {

class HoldSwitch {
 public:
  HoldSwitch(Conversation& talk, Hold& hold, Kills& kills) : talk_(talk), hold_(hold), kills_(kills) {}

  /// An H more might switch it either way.
  [[nodiscard]] Result<> may_switch() const;
  /// Says this, behind which the hold is on, or off. H is a switch: it is said only when it changes what is
  /// wanted.
  Task<Result<>> say(std::string text, bool on, Priority priority);
  /// A hold that was left on stands before a command of a move of ours: nothing turns.
  [[nodiscard]] bool keeps_our_move() const { return hold_.is_to_be_released(); }
  /// Before anything is run: whether it is on is known afterwards.
  Task<Result<>> settle();

 private:
  Conversation& talk_;
  Hold& hold_;
  Kills& kills_;
};

}  // namespace hw::vxm
