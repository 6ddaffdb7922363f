#pragma once
// What the steps and the speed of jogging are for, and are shown in.
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// All that the steps and the speed are for: on a bus the axes of all its devices.
template <class Act>
void for_each_axis(const gui::Frame& f, Act act) {
  const auto of = [&](const gui::Tab& tab) {
    for (std::size_t i = 0; i < tab.catalog().axes.size(); ++i)
      act(tab, AxisId{static_cast<std::uint8_t>(i)});
  };
  if (!f.tab.bus) return of(f.tab);
  for (const gui::Tab* member : f.tab.bus->members) of(*member);
}

/// For steps and speed of all axes: the real unit that all have in common, without the sign of those that
/// count against their steps, or else what the controllers themselves count in.
[[nodiscard]] gui::DisplayUnit common_unit(const gui::Frame& frame);

}  // namespace hw::panels
