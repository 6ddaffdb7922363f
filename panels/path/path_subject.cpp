#include "panels/path/path_subject.h"

#include "gui/model/tab.h"
#include "gui/model/units_format.h"

namespace hw::panels {

using namespace gui;

drawing::Point3 place_of(const Tab& tab, const std::array<Steps, max_axes>& position, const PathAxes& axes) {
  const auto on = [&](AxisId a) { return from_steps(position[a.index], tab.unit(a)); };
  return {on(axes.right), on(axes.up), axes.third ? on(*axes.third) : 0};
}

std::optional<drawing::Point3> place_now(const Frame& f, const PathAxes& axes) {
  std::array<Steps, max_axes> position{};
  for (const std::optional<AxisId> axis : {std::optional(axes.right), std::optional(axes.up), axes.third}) {
    if (!axis) continue;
    const AxisState& state = f.now.axes[axis->index];
    if (!f.connected() || !state.position_known) return std::nullopt;
    position[axis->index] = state.position;
  }
  return place_of(f.tab, position, axes);
}

std::optional<drawing::Point3> place_now(const Frame& f, const PathSubject& s) {
  return s.own ? s.own->here : place_now(f, s.axes);
}

bool one_unit(const Tab& tab, const PathSubject& s) { return s.own || one_unit(tab, s.axes); }

std::string_view unit_name(const Tab& tab, const PathSubject& s, AxisId axis) {
  return s.own ? s.own->unit : std::string_view(tab.unit(axis).name);
}

bool one_unit(const Tab& tab, const PathAxes& axes) {
  const std::string& name = tab.unit(axes.right).name;
  return name == tab.unit(axes.up).name && (!axes.third || name == tab.unit(*axes.third).name);
}

}  // namespace hw::panels
