#include "panels/contour/contour_unit.h"

#include <algorithm>

#include "gui/model/tab.h"

namespace hw::panels {

using namespace gui;

double ContourUnit::typed(double steps) const {
  const double ten = std::pow(10.0, decimals);
  return std::round(shown(steps) * ten) / ten;
}

std::optional<double> ContourUnit::steps(const NumberField& field) const {
  const auto typed = field.value();
  return typed ? std::optional(std::round(*typed / per_step) + 0.0) : std::nullopt;  // no minus zero
}

std::optional<double> ContourUnit::steps_long(const NumberField& field) const {
  const auto typed = field.value();
  return typed ? std::optional(std::round(*typed / std::abs(per_step))) : std::nullopt;
}

NumberRange ContourUnit::places(const Catalog& c) const {
  const double a = shown(static_cast<double>(c.position_min.value));
  const double b = shown(static_cast<double>(c.position_max.value));
  return {std::min(a, b), std::max(a, b), decimals, {}};
}

NumberRange ContourUnit::lengths(const Catalog& c) const {
  return {0, shown_length(static_cast<double>(c.position_max.value)), decimals, name};
}

NumberRange ContourUnit::speeds(const Catalog& c) const {
  return {shown_length(1), shown_length(c.jog_speed_max.value), decimals, of_speed};
}

ContourUnit contour_unit(const Frame& f, int axis) {
  const DisplayUnit& unit = f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(axis)});
  if (unit.real) return {unit.name, unit.per_step, unit.decimals, unit.name + "/s"};
  return {f.catalog.step_word, 1, 0, f.catalog.step_word + "/s"};
}

ContourUnit contour_unit(const Frame& f, int right, int up) {
  ContourUnit unit = contour_unit(f, right);
  return unit == contour_unit(f, up) ? unit
                                     : ContourUnit{f.catalog.step_word, 1, 0, f.catalog.step_word + "/s"};
}

}  // namespace hw::panels
