#pragma once
// Where the console speaks by itself: the status line, and the banner over the centre.
#include "gui/surface/layout.h"

namespace hw::gui {

class Console;
class Tab;
class Ui;

void draw_status_line(Ui& ui, Console& console, const Layout& layout);
/// At the top of `below`, the part under the panel tabs, which gives way: what is above keeps its place. In
/// one bar where that is low, over the status line where there is none. Returns what it takes of it, logical;
/// 0: nothing is wrong.
float draw_banner(Ui& ui, Console& console, Tab& tab, const Layout& layout, const Box& below);

}  // namespace hw::gui
