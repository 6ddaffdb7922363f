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
  void begin() { reported_ = false; }
  /// `state`: the reply to V. While a program runs, F is dropped and an echo looks like a status byte: only
  /// the state and the positions are believed until F is taken.
  Task<Result<>> end(char state);
  /// Call before a request, whose reply would look like the echo: ends the echo.
  Task<Result<>> end_before_request();

 private:
  const Console& console_;
  Conversation& conversation_;
  bool reported_ = false;
};

}  // namespace hw::vxm
