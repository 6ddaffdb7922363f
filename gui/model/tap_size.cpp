#include "gui/model/tap_size.h"

#include <algorithm>
#include <cmath>

#include "gui/model/bus.h"

namespace hw::gui {
namespace {

constexpr std::string_view between_names = ", ";

template <class Act>
void for_each_length_unit(const Tab& tab, Act act) {
  const auto of = [&](const Tab& one) {
    for (std::uint8_t i = 0; i < one.catalog().axes.size(); ++i) act(one.settings.units().length(AxisId{i}));
  };
  if (!tab.bus) return of(tab);
  for (const Tab* member : tab.bus->members) of(*member);
}

/// The number on the button, from the steps that it rounds to for that unit.
double number_of(Steps chosen, const DisplayUnit& unit) {
  const double reached = from_steps(chosen, unit);
  const double round = std::pow(10.0, std::round(std::log10(reached)));
  return to_steps(round, unit) == chosen ? round : reached;
}

bool names_it(std::string_view names, std::string_view name) {
  while (!names.empty()) {
    const std::size_t end = std::min(names.find(between_names), names.size());
    if (names.substr(0, end) == name) return true;
    names.remove_prefix(std::min(end + between_names.size(), names.size()));
  }
  return false;
}

}  // namespace

const DisplayUnit* unit_of_taps(const Tab& tab) {
  const DisplayUnit *first = nullptr, *first_real = nullptr;
  bool alike = true;
  for_each_length_unit(tab, [&](const DisplayUnit& unit) {
    if (!first) first = &unit;
    if (!first_real && unit.real) first_real = &unit;
    alike = alike && unit.real == first->real && unit.per_step == first->per_step && unit.name == first->name;
  });
  return alike ? nullptr : first_real;
}

Steps tap_of(const Tab& tab, AxisId axis) {
  const Steps chosen = tab.settings.profile.jog_step;
  if (chosen <= Steps(1)) return chosen;  // "1 step" is one of each
  const DisplayUnit* chosen_in = unit_of_taps(tab);
  if (!chosen_in) return chosen;
  return std::max(Steps(1), to_steps(number_of(chosen, *chosen_in), tab.settings.units().length(axis)));
}

UnitNames::UnitNames(const Tab& tab) {
  for_each_length_unit(tab, [this](const DisplayUnit& unit) { add(unit.name); });
}

void UnitNames::add(std::string_view name) {
  const std::string_view before = size_ > 0 ? between_names : std::string_view();
  if (names_it(view(), name) || size_ + before.size() + name.size() > bytes_.size()) return;
  for (const std::string_view part : {before, name}) {
    std::copy(part.begin(), part.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += part.size();
  }
}

}  // namespace hw::gui
