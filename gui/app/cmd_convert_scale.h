#pragma once
// Reads the steps of an axis per mm, or per inch with --inch, from the command line or from the console's
// profile.
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "gui/app/cli.h"

namespace hw::app {

/// The scales of the axes that draw: from --per-unit, --step-length or --profile, else 1.
[[nodiscard]] Result<std::vector<double>> read_scales(const Given& given, const Catalog& catalog,
                                                      const std::vector<std::string>& axes);
/// The scale of an axis that lowers the tool: from --pen-per-unit or --profile, else `otherwise`.
[[nodiscard]] Result<double> read_pen_scale(const Given& given, const Catalog& catalog,
                                            const std::string& axis, double otherwise);

}  // namespace hw::app
