#include "core/device/axis_check.h"

#include <fmt/core.h>

#include "core/device/catalog.h"

namespace hw {

std::string describe_no_axis(int axis) { return fmt::format("There is no axis {}.", axis + 1); }

Result<> check_axis(const Catalog& catalog, int axis) {
  if (axis >= 0 && axis < static_cast<int>(catalog.axes.size())) return {};
  return fail(FaultKind::refused, describe_no_axis(axis), "Nothing was sent.");
}

}  // namespace hw
