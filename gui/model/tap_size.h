#pragma once
// How far a tap of a jog button or key moves an axis: the chosen step, which is a number in the unit of each
// axis where the axes that share the choice have different ones, and in steps where an axis has none.
#include <array>
#include <string_view>

#include "gui/model/tab.h"

namespace hw::gui {

/// The unit whose steps are chosen where the axes have different ones: that of the first axis with a unit of
/// its own, without the sign of axes that count against their steps. Null: all have the same, or none has
/// one. On a bus, the axes of all its devices share the choice. Valid until the profile is edited.
[[nodiscard]] const DisplayUnit* unit_of_taps(const Tab& tab);
[[nodiscard]] Steps tap_of(const Tab& tab, AxisId axis);

/// "mm, °, steps": each unit of the axes that share the choice once. On the stack; what has no room is left
/// out.
class UnitNames {
 public:
  explicit UnitNames(const Tab& tab);
  [[nodiscard]] std::string_view view() const { return {bytes_.data(), size_}; }

 private:
  void add(std::string_view name);

  std::array<char, 96> bytes_;
  std::size_t size_ = 0;
};

}  // namespace hw::gui
