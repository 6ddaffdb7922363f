#include "gui/model/axis_units.h"

#include <algorithm>
#include <cmath>

#include "gui/model/kept_unit.h"

namespace hw::gui {
namespace {

/// The conversion that the profile names for this axis; without one, the controller's own steps.
DisplayUnit display_unit(const Catalog& catalog, const Profile& profile, std::size_t axis) {
  const bool in_steps = profile.unit.empty() || profile.unit == catalog.step_word;
  return kept_unit(catalog, in_steps ? AxisProfile() : profile.axes[axis]);
}

}  // namespace

void AxisUnits::work_out(const Catalog& catalog, const Profile& profile) {
  for (std::size_t i = 0; i < std::min(catalog.axes.size(), units_.size()); ++i) {
    Units& axis = units_[i];
    axis.shown = axis.length = display_unit(catalog, profile, i);
    axis.length.per_step = std::fabs(axis.length.per_step);
    axis.counted = kept_unit(catalog, AxisProfile());
  }
  name_counting(catalog);
}

void AxisUnits::follow_counting(const Catalog& catalog, const Snapshot& now) {
  for (std::size_t i = 0; i < units_.size(); ++i) units_[i].in_counts = now.axes[i].in_counts;
  name_counting(catalog);
}

void AxisUnits::name_counting(const Catalog& catalog) {
  if (catalog.loop_word.empty()) return;
  for (std::size_t i = 0; i < std::min(catalog.axes.size(), units_.size()); ++i) {
    Units& axis = units_[i];
    const std::string& word = axis.in_counts ? catalog.loop_word : catalog.step_word;
    for (DisplayUnit* unit : {&axis.shown, &axis.length, &axis.counted})
      if (!unit->real && unit->name != word) unit->name = word;
  }
}

}  // namespace hw::gui
