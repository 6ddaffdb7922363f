#pragma once
// The console's own messages: the status line, and the banner over the centre.
#include "gui/surface/layout.h"

namespace hw::gui {

struct BannerSubject;
class Console;
class Tab;
class Ui;

/// `in_banner`: the subject of the banner, which the line does not repeat.
void draw_status_line(Ui& ui, Console& console, const Layout& layout, const BannerSubject& in_banner);
/// Draws the banner at the top of `below`, the part under the panel tabs, which shrinks; nothing above it
/// moves. If that part is low, the banner is one bar; if there is no such part, it lies over the status line.
/// Returns the height taken, logical; 0: there is no banner.
float draw_banner(Ui& ui, Console& console, Tab& tab, const BannerSubject& subject, const Layout& layout,
                  const Box& below);

}  // namespace hw::gui
