#pragma once
// The body of the window: three columns, or a strip and one column, or a page.
#include "gui/surface/layout.h"

namespace hw::gui {

struct BannerSubject;
class Console;
class Tab;
class Ui;

/// Returns the subject of the banner that it has drawn.
BannerSubject draw_workspace(Ui& ui, Console& console, const Layout& layout);
/// Draws the help, beside the positions and motion controls. Call after the workspace: it lies over that.
void draw_sheet(Ui& ui, Console& console, const Layout& layout);
/// Narrow: the height that the positions of this controller need, logical.
float strip_height(const Tab& tab);

}  // namespace hw::gui
