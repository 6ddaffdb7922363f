#include "gui/model/tap_size.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gui/model/bus.h"

namespace hw::gui {
namespace {

DisplayUnit without_sign(DisplayUnit unit) {
  unit.per_step = std::fabs(unit.per_step);
  return unit;
}

/// The number on the button, from the steps that it rounds to for the first axis.
double number_of(Steps chosen, const DisplayUnit& first) {
  const double reached = from_steps(chosen, first);
  const double round = std::pow(10.0, std::round(std::log10(reached)));
  return to_steps(round, first) == chosen ? round : reached;
}

bool says(const std::string& names, const std::string& name) {
  return names == name || names.starts_with(name + ", ") || names.ends_with(", " + name) ||
         names.find(", " + name + ", ") != std::string::npos;
}

}  // namespace

DisplayUnit unit_of_taps(const Tab& tab) {
  DisplayUnit unit;
  std::string names;
  bool first = true, all_real = true, alike = true;
  const auto look_at = [&](const Tab& of) {
    for (std::uint8_t i = 0; i < of.catalog().axes.size(); ++i) {
      const DisplayUnit other = without_sign(of.unit(AxisId{i}));
      all_real = all_real && other.real;
      if (first) unit = other, names = other.name;
      first = false;
      alike = alike && other.name == unit.name && other.per_step == unit.per_step;
      if (!says(names, other.name)) names += ", " + other.name;
    }
  };
  if (tab.bus)
    for (const Tab* member : tab.bus->members) look_at(*member);
  else
    look_at(tab);
  if (!all_real || alike) return {};
  unit.name = names;
  return unit;
}

Steps tap_of(const Tab& tab, AxisId axis) {
  const Steps chosen = tab.jog_step();
  if (chosen <= Steps(1)) return chosen;  // "1 step" is one of each
  const DisplayUnit first = unit_of_taps(tab);
  if (!first.real) return chosen;
  const Steps own = to_steps(number_of(chosen, first), without_sign(tab.unit(axis)));
  return std::max(Steps(1), own);
}

}  // namespace hw::gui
