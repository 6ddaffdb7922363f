#pragma once
// The places to which a text in the controllers' own language sends the axes. Pure.
#include <optional>
#include <string_view>

#include "core/device/snapshot.h"
#include "core/device/text_goals.h"
#include "core/devices/arcus/forms.h"

namespace hw::arcus {

/// `own`: address of the device; -1: it has none. `incremental`: its move mode; none: not known.
TextGoals goals_of(const Forms& forms, std::string_view text, int own, std::optional<bool> incremental,
                   const Snapshot& now);

}  // namespace hw::arcus
