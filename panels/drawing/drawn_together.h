#pragma once
// Helps to show a drawing that several controllers of one axis each draw together on their bus. The frame's
// catalog is then that of all controllers (catalog_together()), and its tab that of one of them.
#include <string>
#include <string_view>

#include "core/sequence/places_before.h"
#include "gui/model/bus.h"
#include "gui/model/tab.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// Why a drawing cannot begin.
inline constexpr std::string_view position_not_known =
    "The position of one of its axes is not known. Home it, or set its position.";
/// A stop came while the question was open.
inline constexpr std::string_view nothing_started = "A stop came first. Nothing was started.";

[[nodiscard]] inline bool draws_together(const gui::Frame& f) {
  return f.tab.bus && f.catalog.axes.size() > f.tab.catalog().axes.size();
}
/// The tab that owns an axis of the frame's catalog.
[[nodiscard]] inline gui::Tab& owner_of(const gui::Frame& f, int axis) {
  return draws_together(f) ? *f.tab.bus->members[static_cast<std::size_t>(axis)] : f.tab;
}
[[nodiscard]] inline const gui::DisplayUnit& unit_of_axis(const gui::Frame& f, int axis) {
  return owner_of(f, axis).settings.unit(AxisId{static_cast<std::uint8_t>(draws_together(f) ? 0 : axis)});
}
[[nodiscard]] inline const PiecesState& pieces_of(const gui::Frame& f) {
  return draws_together(f) ? f.tab.bus->pieces() : f.now.pieces;
}
/// "X at 12.500 mm, Y at 3.000 mm". It says "at", because some axes have numbers for names. Axes at unknown
/// positions are left out.
[[nodiscard]] std::string places_in_words(const gui::Frame& f, const sequence::Sequence& of,
                                          const sequence::Places& places);

}  // namespace hw::panels
