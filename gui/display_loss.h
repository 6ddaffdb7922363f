#pragma once
// X ends a program where it stands when its display goes away (an ssh -X that breaks, a server that dies),
// and when a request to it fails. A held jog would go on: it is let go first.
#include <functional>

namespace hw::gui {

/// After the window was opened; where the display is no X display nothing is to be guarded. Both are called
/// on the main thread, within whatever it just asks of X. `lost`: nothing may be drawn or asked of the
/// display any more; the program ends when it returns. `failed`: a request failed, and the display is still
/// there.
void guard_display(std::function<void()> lost, std::function<void()> failed);

}  // namespace hw::gui
