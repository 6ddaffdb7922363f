#pragma once
// Reads the options of `handwheel convert`.
#include "core/session/conversion.h"
#include "gui/app/cli.h"

namespace hw::app {

/// The fault names the option that is not understood.
[[nodiscard]] Result<ConversionOptions> read_conversion(const Given& given, const Catalog& catalog);

}  // namespace hw::app
