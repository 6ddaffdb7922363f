#pragma once
// X ends a program where it stands when its display goes away (an ssh -X that breaks, a server that dies),
// and when a request to it fails. A held jog would go on: it is let go first.
#include <functional>

namespace hw::gui {

/// Made after the window was opened; where the display is no X display nothing is to be guarded. One at a
/// time. Both are called on the main thread, within whatever it just asks of X, and never after the guard has
/// gone. `lost`: nothing may be drawn or asked of the display any more; the program ends when it returns.
/// `failed`: a request failed, and the display is still there.
class DisplayGuard {
 public:
  DisplayGuard(std::function<void()> lost, std::function<void()> failed);
  ~DisplayGuard();
  DisplayGuard(const DisplayGuard&) = delete;
  DisplayGuard& operator=(const DisplayGuard&) = delete;
};

}  // namespace hw::gui
