#include "gui/model/clearing.h"

#include <algorithm>
#include <vector>

namespace hw::gui {
namespace {

IntentBody action_intent(const Catalog& catalog, int action, AxisId axis) {
  std::vector<std::int64_t> values;
  for (const ActionField& field : catalog.actions[static_cast<std::size_t>(action)].fields)
    values.push_back(field.id == "axis" ? axis.index : field.fallback);
  return intent::Act(action, std::move(values));
}

bool names_axis(const ActionInfo& action) {
  return std::any_of(action.fields.begin(), action.fields.end(),
                     [](const ActionField& field) { return field.id == "axis"; });
}

/// The clearing action in the table of its axes; -1: none.
int action_for(const Catalog& catalog, bool error) {
  using Shows = AxisColumn::Shows;
  for (const AxisTable& table : catalog.axis_tables)
    for (const AxisColumn& column : table.columns) {
      const bool clears_flag =
          column.shows == Shows::action && !column.state.empty() && column.verb_off.empty();
      if (error ? column.shows == Shows::motion : clears_flag) return catalog.find_action(column.id);
    }
  return -1;
}

}  // namespace

std::optional<Clearing> clearing_of(const Catalog& catalog, const Snapshot& now, AxisId axis) {
  const AxisState& a = now.axes[axis.index];
  const bool error = a.activity == Activity::error;
  if (!now.link.connected() || (!error && !a.slipped)) return {};
  const int action = action_for(catalog, error);
  if (action >= 0) {
    const ActionInfo& info = catalog.actions[static_cast<std::size_t>(action)];
    const bool of_all = catalog.axes.size() > 1 && !names_axis(info);
    return Clearing{axis, action_intent(catalog, action, axis), info.help, of_all};
  }
  if (!error) return {};
  return Clearing{axis, intent::Stop(), "Stops the controller: that clears its error.", true};
}

std::optional<Clearing> first_clearing(const Catalog& catalog, const Snapshot& now) {
  for (int i = 0; i < now.axis_count; ++i)
    if (auto way = clearing_of(catalog, now, AxisId{static_cast<std::uint8_t>(i)})) return way;
  return {};
}

}  // namespace hw::gui
