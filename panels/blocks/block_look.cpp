#include "panels/blocks/block_look.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/index.h"
#include "gui/model/tab.h"

namespace hw::panels {

using namespace gui;
namespace {

/// The axis is shown in steps if it has a unit that the user has not chosen. If it has no unit, a sequence
/// from elsewhere is shown in its own unit.
sequence::Scale scale_of(const Frame& f, const sequence::Axis& axis, const std::string& own_unit) {
  const int place = f.catalog.find_axis(axis.name);
  if (place < 0) return {own_unit, 1, 6};
  const DisplayUnit& unit = f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(place)});
  if (unit.real) return {unit.name, axis.per_unit * unit.per_step, unit.decimals};
  if (f.tab.settings.profile.axes[ix(place)].unit_choice.empty()) return {own_unit, 1, 6};
  return {f.catalog.step_word, axis.per_unit, 6};
}

sequence::Look look_of(const Frame& f, const sequence::Sequence& s) {
  sequence::Look look = own_look(s);
  bool alike = !s.axes.empty();
  for (std::size_t a = 0; a < s.axes.size() && a < look.axes.size(); ++a) {
    look.axes[a] = scale_of(f, s.axes[a], s.unit);
    alike = alike && look.axes[a].unit == look.axes[0].unit &&
            std::fabs(look.axes[a].factor) == std::fabs(look.axes[0].factor);
  }
  if (alike) look.all = look.axes[0];
  look.all.factor = std::fabs(look.all.factor);
  return look;
}

}  // namespace

std::span<const DisplayUnit> BlockLook::units(const Frame& f) {
  const std::size_t count = std::min(f.catalog.axes.size(), units_.size());
  for (std::size_t a = 0; a < count; ++a)
    if (const DisplayUnit& now = f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(a)}); units_[a] != now)
      units_[a] = now, version_ = ~std::uint64_t{0};
  return {units_.data(), count};
}

bool BlockLook::follow(const Frame& f, const sequence::Editor& editor) {
  units(f);
  if (std::exchange(version_, editor.version()) == editor.version()) return false;
  sequence::Look now = look_of(f, editor.sequence());
  if (now == look_) return false;
  look_ = std::move(now);
  return true;
}

}  // namespace hw::panels
