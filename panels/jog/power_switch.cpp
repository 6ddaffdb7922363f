#include "panels/jog/power_switch.h"

#include <bit>
#include <cmath>

#include "core/device/refusals.h"
#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

std::uint32_t powerless_axes(const Frame& f) {
  if (!f.connected()) return 0;
  const std::size_t count = f.catalog.axes.size();
  std::uint32_t axes = 0;
  for (std::uint8_t i = 0; i < count; ++i)
    if ((count <= 4 || f.tab.view.chosen_axis == AxisId{i}) && powerless(f.catalog, f.now, AxisId{i}))
      axes |= 1u << i;
  return axes;
}

std::string_view powerless_words(const Frame& f, std::uint32_t axes) {
  if (axes == 0) return {};
  if (std::popcount(axes) > 1) return "Motor power is off. Switch on:";
  const std::string_view why = f.tab.why_not_move(AxisId{static_cast<std::uint8_t>(std::countr_zero(axes))});
  return why.substr(0, why.find(". ") + 1);  // the switch, which is the remedy, is beside it
}

Rect draw_power_switches(Frame& f, const Rect& place, std::uint32_t axes) {
  Ui& ui = f.ui;
  const bool several = std::popcount(axes) > 1;
  ButtonOptions o;
  o.height = 28;
  o.tip = "Switches the motor's current on: it holds, and can move.";
  o.width = several ? 28 : button_width(ui, "Switch on", o);
  const float top = std::floor(place.centre().y - ui.px(o.height / 2));
  Rect left = place;
  for (int i = max_axes - 1; i >= 0; --i) {
    if ((axes >> i & 1u) == 0) continue;
    const std::string& name = f.catalog.axes[static_cast<std::size_t>(i)].name;
    left.max.x -= ui.px(o.width);
    ImGui::SetCursorScreenPos(ImVec2(left.max.x, top));
    if (button(ui, Path("jog/{}/power", name), several ? std::string_view(name) : "Switch on", o).clicked)
      f.send(intent::SetPower(i, true));
    left.max.x -= ui.px(close_between);
  }
  return left;
}

}  // namespace hw::panels
