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
/// A tab of the top bar's height (56) at the cursor, with a hairline at its right. EMULATED is written out if
/// it fits beside the state; otherwise only its shape is shown.
Touch controller_tab(Ui& ui, std::string_view id, const ControllerTab& tab, float width = 176);

struct PanelTab {
  std::string_view id;    ///< "tab/program"
  std::string_view name;  ///< "Program"
  std::string_view disabled = {};
};
/// A row 40 high with a hairline below. A row that is too long scrolls with the mouse wheel. Returns the
/// index chosen in this frame, or -1.
int panel_tabs(Ui& ui, std::span<const PanelTab> tabs, int active);

}  // namespace hw::gui
