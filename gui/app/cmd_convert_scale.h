#pragma once
// How many steps of an axis are in a mm, or in an inch with --inch: as typed, or as the console keeps it.
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "gui/app/cli.h"

namespace hw::app {

/// Of the axes that draw: --per-unit, --step-length, --profile, else 1.
[[nodiscard]] Result<std::vector<double>> read_scales(const Given& given, const Catalog& catalog,
                                                      const std::vector<std::string>& axes);
/// Of an axis that lowers the tool: --pen-per-unit, --profile, else `otherwise`.
[[nodiscard]] Result<double> read_pen_scale(const Given& given, const Catalog& catalog,
                                            const std::string& axis, double otherwise);

}  // namespace hw::app
