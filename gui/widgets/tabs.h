#pragma once
// Tabs of controllers (active: panel ground and a line on top) and of panels (a line below).
#include <span>
#include <string_view>

#include "gui/widgets/icons.h"
#include "gui/widgets/touch.h"

namespace hw::gui {

struct ControllerTab {
  std::string_view name;
  Icon icon = Icon::ring;  ///< the worst state of the controller
  Tone tone = Tone::ink2;
  std::string_view state = {};  ///< "moving", "late, 0.4 s"
  bool emulated = false;
  bool active = false;
};
/// Fills the height of the top bar (56) at the cursor and ends with a hairline at its right. EMULATED stands
/// there in words where it has room beside the state, else as its shape.
Touch controller_tab(Ui& ui, std::string_view id, const ControllerTab& tab, float width = 176);

struct PanelTab {
  std::string_view id;    ///< "tab/program"
  std::string_view name;  ///< "Program"
  std::string_view disabled = {};
};
/// A row of 40 with a hairline below. Returns the index just chosen, or -1. When too long, it scrolls with
/// the wheel.
int panel_tabs(Ui& ui, std::span<const PanelTab> tabs, int active);

}  // namespace hw::gui
