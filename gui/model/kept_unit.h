#pragma once
// The unit that the console keeps for an axis, whether the numbers are shown in it now or in steps.
#include "core/device/catalog.h"
#include "core/session/profile.h"
#include "gui/model/units_format.h"

namespace hw::gui {

/// The conversion that the profile names for this axis; without one, the controller's own steps.
DisplayUnit kept_unit(const Catalog& catalog, const AxisProfile& axis);

}  // namespace hw::gui
