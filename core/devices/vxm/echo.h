#pragma once
// A controller that echoes what it is sent: ended by F, which it does not take while a program runs.
#include <utility>

#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"

namespace hw::vxm {

class Echo {
 public:
  Echo(const Console& console, Conversation& talk) : console_(console), talk_(talk) {}

  /// A new wire.
  void begin() { told_ = false; }
  /// `state`: what V has told. While a program runs F is dropped, and nothing tells an echo from a status
  /// byte: only the state and the positions are believed until F is taken.
  Task<Result<>> end(char state);
  /// Somebody wants something of it: what it would answer could not be told from the echo.
  Task<Result<>> hear_without();

 private:
  const Console& console_;
  Conversation& talk_;
  bool told_ = false;
};

}  // namespace hw::vxm
