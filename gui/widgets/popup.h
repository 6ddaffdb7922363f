#pragma once
// A list of actions under a button that was clicked, in rows of 32 with paths of their own.
#include <string_view>

#include "gui/widgets/touch.h"

namespace hw::gui {

/// True while it is open: draw popup_row()s, then end_popup(). `name`: unique; `rows`: its height in rows,
/// whole or not. `right`: its right edge is the button's.
bool begin_popup(Ui& ui, const char* name, const Touch& button, float width, float rows, bool right = false);
/// True when the row was chosen; the list closes by itself.
bool popup_row(Ui& ui, std::string_view id, std::string_view label, std::string_view caption = {},
               bool on = false, std::string_view disabled = {});
/// A hairline between groups of rows; counts as no row.
void popup_line(Ui& ui);
void end_popup();

}  // namespace hw::gui
