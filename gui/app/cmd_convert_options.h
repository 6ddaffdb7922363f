#pragma once
// What the options of `handwheel convert` ask for.
#include "core/session/conversion.h"
#include "gui/app/cli.h"

namespace hw::app {

/// The fault says which of them is not understood.
[[nodiscard]] Result<ConversionOptions> read_conversion(const Given& given, const Catalog& catalog);

}  // namespace hw::app
