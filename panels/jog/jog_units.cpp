#include "panels/jog/jog_units.h"

#include <algorithm>
#include <utility>

#include "gui/model/tap_size.h"

namespace hw::panels {

using namespace gui;
namespace {

/// The controllers' own unit. It has no word if some axes count pulses and others counts.
const DisplayUnit& counted_by_all(const Frame& f) {
  static const DisplayUnit mixed{"", 1, 0, false};
  const DisplayUnit& first = f.tab.settings.units().counted(AxisId{0});
  bool same = true;
  for_each_axis(f, [&](const Tab& tab, AxisId axis) {
    same = same && tab.settings.units().counted(axis).name == first.name;
  });
  return same ? first : mixed;
}

}  // namespace

const DisplayUnit& common_unit(const Frame& f) {
  const DisplayUnit& unit = f.tab.settings.units().length(AxisId{0});
  bool same = unit.real;
  for_each_axis(f, [&](const Tab& tab, AxisId axis) {
    const DisplayUnit& other = tab.settings.units().length(axis);
    same = same && other.real && other.name == unit.name && other.per_step == unit.per_step;
  });
  return same ? unit : counted_by_all(f);
}

Pps held_speed(const Tab& tab, AxisId axis) {
  const Pps chosen = tab.settings.jog_speed(axis);
  return chosen.value > 0 ? chosen : tab.now().axes[axis.index].own_speed;
}

/// "X 0.250 mm, others 1 step": the words that most axes share are written once.
template <class Words>
void OwnUnits::list(const Frame& f, std::string_view head, const Words& words_of) {
  NumberText first, last;
  int axes = 0, like_first = 0, like_last = 0;
  for_each_axis(f, [&](const Tab& tab, AxisId axis) {
    last = words_of(tab, axis);
    if (axes++ == 0) first = last;
  });
  for_each_axis(f, [&](const Tab& tab, AxisId axis) {
    const NumberText words = words_of(tab, axis);
    like_first += words.view() == first.view();
    like_last += words.view() == last.view();
  });
  const int shared = std::max(like_first, like_last);
  const NumberText& common = like_first > like_last ? first : last;
  append(head);
  std::string_view before = ": ";
  for_each_axis(f, [&](const Tab& tab, AxisId axis) {
    const NumberText words = words_of(tab, axis);
    if (shared > 1 && words.view() == common.view()) return;
    append(std::exchange(before, ", "));
    append(tab.catalog().axes[axis.index].name);
    append(" ");
    append(words);
  });
  if (shared > 1) {
    append(before);
    append(shared == axes ? "all " : "others ");
    append(common);
  }
  append(".");
}

OwnUnits::OwnUnits(const Frame& f) {
  if (!unit_of_taps(f.tab)) return;
  list(f, "A tap", [](const Tab& tab, AxisId axis) {
    return format_with_unit(tap_of(tab, axis), tab.settings.units().length(axis));
  });
  list(f, " Held", [](const Tab& tab, AxisId axis) {
    return format_speed(held_speed(tab, axis), tab.settings.units().length(axis));
  });
}

/// The first part that does not fit, and all after it, are left out.
void OwnUnits::append(std::string_view text) {
  full_ = full_ || size_ + text.size() > bytes_.size();
  if (full_) return;
  std::copy(text.begin(), text.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += text.size();
}

}  // namespace hw::panels
