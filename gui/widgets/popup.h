#pragma once
// A list of actions below a button, in rows 32 high. Each row has an id of its own.
#include <string_view>

#include "gui/widgets/touch.h"

namespace hw::gui {

/// Returns true while the list is open: then draw the rows with popup_row() and call end_popup(). `name` is
/// unique. `rows` is the height in rows and may be a fraction. `right` aligns the right edges of list and
/// button.
bool begin_popup(Ui& ui, const char* name, const Touch& button, float width, float rows, bool right = false);
/// Returns true when the row was chosen; the list is then closed.
bool popup_row(Ui& ui, std::string_view id, std::string_view label, std::string_view caption = {},
               bool on = false, std::string_view disabled = {});
/// A hairline between groups of rows; it does not count as a row.
void popup_line(Ui& ui);
void end_popup();

}  // namespace hw::gui
