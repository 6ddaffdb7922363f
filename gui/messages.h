#pragma once
// Where the console speaks by itself: the status line, and the banner over the centre.
#include "gui/layout.h"

namespace hw::gui {

class Console;
class Tab;
class Ui;

void draw_status_line(Ui& ui, Console& console, const Layout& layout);
/// At the cursor, across the current window; draws nothing when nothing is wrong.
void draw_banner(Ui& ui, Console& console, Tab& tab, const Layout& layout);

}  // namespace hw::gui
