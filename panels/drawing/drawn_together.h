#pragma once
// A drawing that several controllers of one axis each draw together on their bus. The frame's catalog is then
// that of all (catalog_together()), and its tab that of one.
#include <string>

#include "core/sequence/places_before.h"
#include "gui/model/bus.h"
#include "gui/model/tab.h"
#include "gui/shell/frame.h"

namespace hw::panels {

[[nodiscard]] inline bool draws_together(const gui::Frame& f) {
  return f.tab.bus && f.catalog.axes.size() > f.tab.catalog().axes.size();
}
/// The tab that owns an axis of the frame's catalog.
[[nodiscard]] inline gui::Tab& owner_of(const gui::Frame& f, int axis) {
  return draws_together(f) ? *f.tab.bus->members[static_cast<std::size_t>(axis)] : f.tab;
}
[[nodiscard]] inline const gui::DisplayUnit& unit_of_axis(const gui::Frame& f, int axis) {
  return owner_of(f, axis).unit(AxisId{static_cast<std::uint8_t>(draws_together(f) ? 0 : axis)});
}
[[nodiscard]] inline const PiecesState& pieces_of(const gui::Frame& f) {
  return draws_together(f) ? f.tab.bus->pieces() : f.now.pieces;
}
/// "X at 12.500 mm, Y at 3.000 mm", as some axes have numbers for names; of axes whose place is not known
/// nothing.
[[nodiscard]] std::string places_in_words(const gui::Frame& f, const sequence::Sequence& of,
                                          const sequence::Places& places);

}  // namespace hw::panels
