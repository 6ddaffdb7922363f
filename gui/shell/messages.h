#pragma once
// The console's own messages: the status line, and the banner over the centre.
#include "gui/surface/layout.h"

namespace hw::gui {

struct BannerSubject;
class Console;
class Tab;
class Ui;

/// `in_banner`: what need not be said twice.
void draw_status_line(Ui& ui, Console& console, const Layout& layout, const BannerSubject& in_banner);
/// Draws the banner at the top of `below`, the part under the panel tabs, which shrinks; what is above keeps
/// its place. Where that part is low, it shares one bar; where there is none, it is over the status line.
/// Returns the height taken, logical; 0: nothing is wrong.
float draw_banner(Ui& ui, Console& console, Tab& tab, const BannerSubject& subject, const Layout& layout,
                  const Box& below);

}  // namespace hw::gui
