#pragma once
#include <string_view>

#include "core/session/address.h"
#include "gui/surface/ui.h"

namespace hw::gui {
class Console;
class Tab;
}  // namespace hw::gui

namespace hw::panels {

/// Draws a numbered sentence.
void draw_point(gui::Ui& ui, int number, std::string_view words, float width);
/// The tab opened with this address; for a bus the chosen tab; null: not open.
gui::Tab* find_open(const gui::Console& console, const Address& address);

}  // namespace hw::panels
