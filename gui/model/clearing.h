#pragma once
// The command that clears an axis' error: offered wherever the error is shown.
#include <optional>
#include <string_view>
#include <variant>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"

namespace hw::gui {

struct Clearing {
  AxisId axis;
  IntentBody request;
  std::string_view help;  ///< in the catalog's memory
  bool of_all = false;    ///< its command names no axis: it clears those of the others too
  [[nodiscard]] bool stops_all() const { return std::holds_alternative<intent::Stop>(request); }
};

/// Nothing: the axis has no error, or there is no link. A controller without a command for it is stopped.
std::optional<Clearing> clearing_of(const Catalog& catalog, const Snapshot& now, AxisId axis);
/// The first axis with an error to clear.
std::optional<Clearing> first_clearing(const Catalog& catalog, const Snapshot& now);

}  // namespace hw::gui
