#pragma once
// X terminates a program at once when its display goes away (a broken ssh -X, a server that dies) and when
// one of its requests fails. A held jog would continue: it is ended first.
#include <functional>

namespace hw::gui {

/// Create it after the window was opened; without an X display it does nothing. One at a time. Both functions
/// are called on the main thread, inside whatever X call it just made, and never after the guard was
/// destroyed. `lost`: nothing may be drawn or requested from the display any more; the program ends when the
/// function returns. `failed`: a request failed, and the display is still there.
class DisplayGuard {
 public:
  DisplayGuard(std::function<void()> lost, std::function<void()> failed);
  ~DisplayGuard();
  DisplayGuard(const DisplayGuard&) = delete;
  DisplayGuard& operator=(const DisplayGuard&) = delete;
};

}  // namespace hw::gui
