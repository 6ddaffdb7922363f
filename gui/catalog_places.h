#pragma once
// What belongs together on the screen although the catalog tells it in different lists: headings that all
// catalogs write the same. One place, so that no panel spells them.
#include <algorithm>
#include <string_view>

#include "core/device/catalog.h"

namespace hw::gui {

inline constexpr std::string_view buffer_heading = "Buffer";  ///< actions and readouts of buffered moves
inline constexpr std::string_view analog_heading =
    "Analog inputs";  ///< the group by which analog inputs are asked for
inline constexpr std::string_view joystick_heading = "Joystick";  ///< actions that bind axes to analog inputs

/// Index in Catalog::readout_groups; -1: none has this name.
inline int readout_group(const Catalog& catalog, std::string_view name) {
  const auto& groups = catalog.readout_groups;
  const auto found = std::find(groups.begin(), groups.end(), name);
  return found == groups.end() ? -1 : static_cast<int>(found - groups.begin());
}

/// The parameters of buffered moves stand under a heading of Setup that begins like their actions'.
inline bool belongs_to_buffer(const ParamInfo& param) { return param.group.starts_with(buffer_heading); }

}  // namespace hw::gui
