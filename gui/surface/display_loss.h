#pragma once
// X terminates a program at once when the display is lost (ssh -X breaks, the server ends) or when a request
// fails. A held jog would then continue, so it is ended first.
#include <functional>

namespace hw::gui {

/// Create the guard after the window was opened, one at a time; without an X display it does nothing. Both
/// functions are called on the main thread, inside an X call, and never after the guard was destroyed.
/// `lost`: the display is gone. The function must not draw, or request anything from the display; the program
/// ends when it returns. `failed`: a request failed, but the display is still there.
class DisplayGuard {
 public:
  DisplayGuard(std::function<void()> lost, std::function<void()> failed);
  ~DisplayGuard();
  DisplayGuard(const DisplayGuard&) = delete;
  DisplayGuard& operator=(const DisplayGuard&) = delete;
};

}  // namespace hw::gui
