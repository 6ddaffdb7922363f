#pragma once
#include "gui/shell/panel_entry.h"

namespace hw::panels {

/// All panels of the console, in this order. A new panel is a pair of files and one line there.
gui::PanelList panel_list();

}  // namespace hw::panels
