#pragma once
// Draws the top bar: brand and menu, controllers, link health, STOP ALL.
#include "gui/surface/layout.h"

namespace hw::gui {

class Console;
class Ui;

void draw_top_bar(Ui& ui, Console& console, const Layout& layout);

}  // namespace hw::gui
