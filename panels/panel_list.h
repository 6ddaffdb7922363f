#pragma once
#include "gui/shell/panel_entry.h"

namespace hw::panels {

/// All panels of the console, in their order. A new panel needs its files and a line there.
gui::PanelList panel_list();

}  // namespace hw::panels
