#pragma once
// The unit in which a list of the contour panel is typed: the display unit of its axes, if they share it.
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "gui/shell/frame.h"
#include "gui/widgets/number_field.h"

namespace hw::panels {

struct ContourUnit {
  std::string name;  ///< "mm", or the controller's word for a step
  double per_step = 1;
  int decimals = 0;
  std::string of_speed;  ///< "mm/s"
  bool operator==(const ContourUnit&) const = default;

  [[nodiscard]] double shown(double steps) const { return steps * per_step; }
  [[nodiscard]] double shown_length(double steps) const { return steps * std::abs(per_step); }
  /// A number as a user would type it, rounded to the unit's decimals.
  [[nodiscard]] double typed(double steps) const;
  /// The content of a field in whole steps; nullopt: it is not a number.
  [[nodiscard]] std::optional<double> steps(const gui::NumberField& field) const;
  [[nodiscard]] std::optional<double> steps_long(const gui::NumberField& field) const;
  void put(gui::NumberField& field, double steps) const { field.set(shown(steps), decimals); }
  void put_long(gui::NumberField& field, double steps) const { field.set(shown_length(steps), decimals); }

  [[nodiscard]] gui::NumberRange places(const Catalog& catalog) const;
  [[nodiscard]] gui::NumberRange lengths(const Catalog& catalog) const;
  [[nodiscard]] gui::NumberRange speeds(const Catalog& catalog) const;
};

/// The unit for one axis or two. Two axes shown in different units get steps, because a path has a single
/// speed.
ContourUnit contour_unit(const gui::Frame& frame, int axis);
ContourUnit contour_unit(const gui::Frame& frame, int right, int up);

}  // namespace hw::panels
