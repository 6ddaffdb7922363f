#pragma once
// Ends the echo of a controller by F, which it does not take while a program runs.
#include <utility>

#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"

namespace hw::vxm {

class Echo {
 public:
  Echo(const Console& console, Conversation& conversation) : console_(console), conversation_(conversation) {}

  /// A new wire.
  void begin() { told_ = false; }
  /// `state`: the reply to V. While a program runs, F is dropped and an echo looks like a status byte: only
  /// the state and the positions are believed until F is taken.
  Task<Result<>> end(char state);
  /// Call before a request, whose reply could not be told from the echo: ends the echo.
  Task<Result<>> hear_without();

 private:
  const Console& console_;
  Conversation& conversation_;
  bool told_ = false;
};

}  // namespace hw::vxm
