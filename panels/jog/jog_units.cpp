#include "panels/jog/jog_units.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/model/tap_size.h"

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

OwnUnits::OwnUnits(const Frame& f) {
  bool some_real = false;
  for_each_axis(f, [&](const Tab& tab, AxisId axis) { some_real = some_real || tab.unit(axis).real; });
  if (!some_real || common_unit(f).real) return;
  const auto list = [&](std::string_view head, const auto& words_of) {
    append(head);
    std::string_view before = ": ";
    for_each_axis(f, [&](const Tab& tab, AxisId axis) {
      DisplayUnit unit = tab.unit(axis);
      unit.per_step = std::fabs(unit.per_step);
      append(std::exchange(before, ", "));
      append(tab.catalog().axes[axis.index].name);
      append(" ");
      append(words_of(tab, axis, unit));
    });
    append(".");
  };
  list("A tap", [](const Tab& tab, AxisId axis, const DisplayUnit& unit) {
    return format_with_unit(tap_of(tab, axis), unit);
  });
  list(" Held", [](const Tab& tab, AxisId axis, const DisplayUnit& unit) {
    const Pps chosen = tab.jog_speed(), own = tab.now().axes[axis.index].own_speed;
    return format_speed(chosen.value > 0 ? chosen : own, unit);
  });
}

/// What has no room is left out from the first whole part on.
void OwnUnits::append(std::string_view text) {
  full_ = full_ || size_ + text.size() > bytes_.size();
  if (full_) return;
  std::copy(text.begin(), text.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += text.size();
}

}  // namespace hw::panels
