#include "panels/jog/jog_units.h"

#include <cmath>
#include <utility>

namespace hw::panels {

using namespace gui;
namespace {

/// The controllers' own unit: no word if some count pulses and others counts.
DisplayUnit counted_by_all(const Frame& f) {
  DisplayUnit unit;
  bool first = true;
  for_each_axis(f, [&](const Tab& tab, AxisId axis) {
    const Catalog& c = tab.catalog();
    const bool in_counts = !c.loop_word.empty() && tab.now().axes[axis.index].in_counts;
    const std::string& word = in_counts ? c.loop_word : c.step_word;
    if (std::exchange(first, false))
      unit.name = word;
    else if (unit.name != word)
      unit.name.clear();
  });
  return unit;
}

}  // namespace

DisplayUnit common_unit(const Frame& f) {
  DisplayUnit unit = f.tab.unit(AxisId{0});
  unit.per_step = std::fabs(unit.per_step);
  bool same = unit.real;
  for_each_axis(f, [&](const Tab& tab, AxisId axis) {
    const DisplayUnit& other = tab.unit(axis);
    same = same && other.real && other.name == unit.name && std::fabs(other.per_step) == unit.per_step;
  });
  return same ? unit : counted_by_all(f);
}

}  // namespace hw::panels
