#pragma once
// A drawing that controllers of one axis each draw together on their bus: the frame's catalog is then of all
// of them (catalog_together()), and the tab that of one.
#include "gui/model/bus.h"
#include "gui/model/tab.h"
#include "gui/shell/frame.h"

namespace hw::panels {

[[nodiscard]] inline bool draws_together(const gui::Frame& f) {
  return f.tab.bus && f.catalog.axes.size() > f.tab.catalog().axes.size();
}
/// Whose axis of the frame's catalog it is, and which of its own.
[[nodiscard]] inline gui::Tab& owner_of(const gui::Frame& f, int axis) {
  return draws_together(f) ? *f.tab.bus->members[static_cast<std::size_t>(axis)] : f.tab;
}
[[nodiscard]] inline const gui::DisplayUnit& unit_of_axis(const gui::Frame& f, int axis) {
  return owner_of(f, axis).unit(AxisId{static_cast<std::uint8_t>(draws_together(f) ? 0 : axis)});
}
[[nodiscard]] inline const PiecesState& pieces_of(const gui::Frame& f) {
  return draws_together(f) ? f.tab.bus->pieces() : f.now.pieces;
}

}  // namespace hw::panels
