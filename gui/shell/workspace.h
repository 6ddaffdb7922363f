#pragma once
// Draws the body of the window: three columns, or a strip and one column, or a page.
#include "gui/surface/layout.h"

namespace hw::gui {

struct BannerSubject;
class Console;
class Tab;
class Ui;

/// Draws the columns and the banner. Returns the subject of the banner.
BannerSubject draw_workspace(Ui& ui, Console& console, const Layout& layout);
/// Draws the help beside the positions and motion controls. Call it after draw_workspace(), because the help
/// lies over the workspace.
void draw_sheet(Ui& ui, Console& console, const Layout& layout);
/// The height that the positions of this controller need in a narrow window, logical.
float strip_height(const Tab& tab);

}  // namespace hw::gui
