#include "gui/model/kept_unit.h"

namespace hw::gui {

DisplayUnit kept_unit(const Catalog& catalog, const AxisProfile& axis) {
  if (const OwnUnit& own = axis.own_unit; axis.unit_choice == own_unit_choice && own.per_step != 0)
    return DisplayUnit{own.name, axis.reversed ? -own.per_step : own.per_step, decimals_of(own.per_step),
                       true};
  for (const UnitChoice& choice : catalog.units)
    if (choice.label == axis.unit_choice)
      return DisplayUnit{choice.unit, axis.reversed ? -choice.per_step : choice.per_step, choice.decimals,
                         true};
  DisplayUnit steps;
  steps.name = catalog.step_word;
  return steps;
}

}  // namespace hw::gui
