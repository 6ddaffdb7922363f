#pragma once
// Ends a controller's echo by F, which the controller ignores while a program runs.
#include <utility>

#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"

namespace hw::vxm {

class Echo {
 public:
  Echo(const Console& console, Conversation& conversation) : console_(console), conversation_(conversation) {}

  /// A new wire.
  void begin() { reported_ = false; }
  /// `state`: the reply to V. While a program runs, F is dropped, and an echo looks like a status byte: until
  /// F is accepted, only the state and the positions count.
  Task<Result<>> end(char state);
  /// Ends the echo. Call before a request, whose reply could not be told from the echo.
  Task<Result<>> end_before_request();

 private:
  const Console& console_;
  Conversation& conversation_;
  bool reported_ = false;
};

}  // namespace hw::vxm
