#pragma once
// The axes to which jog steps and speed apply, and the display units of these.
#include <array>
#include <cstddef>
#include <string_view>

#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// Calls `act` for each axis to which steps and speed apply: on a bus the axes of all its devices.
template <class Act>
void for_each_axis(const gui::Frame& f, Act act) {
  const auto of = [&](gui::Tab& tab) {
    for (std::size_t i = 0; i < tab.catalog().axes.size(); ++i)
      act(tab, AxisId{static_cast<std::uint8_t>(i)});
  };
  if (!f.tab.bus) return of(f.tab);
  for (gui::Tab* member : f.tab.bus->members) of(*member);
}

/// The unit for steps and speed of all axes: their common real unit, without the sign of axes that count
/// against their steps; else the controllers' own unit.
[[nodiscard]] const gui::DisplayUnit& common_unit(const gui::Frame& frame);
/// The speed of a held jog: the user's choice, else the controller's own; 0: not known.
[[nodiscard]] Pps held_speed(const gui::Tab& tab, AxisId axis);

/// "A tap: X 0.250 mm, others 1.80\u00B0. Held: X 2.500 mm/s, others 18.00\u00B0/s." for axes with different
/// units; else empty. On the stack.
class OwnUnits {
 public:
  explicit OwnUnits(const gui::Frame& frame);
  [[nodiscard]] std::string_view view() const { return {bytes_.data(), size_}; }

 private:
  template <class Words>
  void list(const gui::Frame& frame, std::string_view head, const Words& words_of);
  void append(std::string_view text);

  std::array<char, 320> bytes_;
  std::size_t size_ = 0;
  bool full_ = false;
};

}  // namespace hw::panels
