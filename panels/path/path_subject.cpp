#include "panels/path/path_subject.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/index.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "panels/drawing/drawn_together.h"

namespace hw::panels {

using namespace gui;
using drawing::Point3;

// ---- directions

const DisplayUnit& Direction::unit() const {
  static const DisplayUnit of_time{"s", 0.001, 2, true};
  return tab ? tab->settings.unit(axis) : of_time;
}

const AxisState* Direction::state() const { return tab ? &tab->now().axes[axis.index] : nullptr; }

double Direction::place(const std::array<Steps, max_axes>& position) const {
  return from_steps(position[axis.index], unit());
}

std::string Direction::words(double units) const {
  return fmt::format("{} {}", name, format_with_unit(to_steps(units, unit()), unit()).view());
}

Directions directions_of(const Frame& f, const PathAxes& axes) {
  Directions d;
  const auto add = [&](AxisId id) {
    const bool together = draws_together(f);
    const std::string_view name =
        id.index < f.catalog.axes.size() ? std::string_view(f.catalog.axes[id.index].name) : "";
    d.all[d.count++] = {&owner_of(f, id.index), together ? AxisId{0} : id, name};
  };
  if (axes.over_time)
    d.all[d.count++] = {nullptr, {}, "time"};
  else
    add(axes.right);
  add(axes.up);
  if (axes.third && !axes.over_time) add(*axes.third);
  return d;
}

double& along(Point3& p, std::size_t direction) { return direction == 0 ? p.x : direction == 1 ? p.y : p.z; }

// ---- position

Instant zero_of_time(const Tab& tab) {
  const Instant begun = tab.now().program.started_at;
  return begun != Instant{} ? begun : const_cast<Tab&>(tab).desk().records.trace.first_at();
}

/// Time advances only while the axis moves, so that nothing is redrawn at rest.
static double seconds_now(Tab& tab) {
  const auto& places = tab.desk().records.trace.places();
  return places.empty() ? 0 : std::max(0.0, seconds(places.back().at - zero_of_time(tab)));
}

std::optional<Point3> place_now(const Frame& f, const PathAxes& axes) {
  const Directions all = directions_of(f, axes);
  Point3 at;
  for (std::size_t n = 0; n < all.count; ++n) {
    const Direction& d = all.all[n];
    if (!d.tab) {
      along(at, n) = seconds_now(*all.all[1].tab);
      continue;
    }
    if (!d.tab->now().link.connected() || !d.state()->position_known) return std::nullopt;
    along(at, n) = from_steps(d.state()->position, d.unit());
  }
  return at;
}

std::optional<Point3> place_now(const Frame& f, const PathSubject& s) {
  return s.own ? s.own->here : place_now(f, s.axes);
}

std::optional<bool> tool_on_now(const TrackAxes& tool, const Snapshot& switching, const Snapshot& lowering,
                                int lowering_axis) {
  if (const int output = tool.tool_output; output >= 0) {
    if (!switching.link.connected() || (switching.outputs_known >> output & 1u) == 0) return std::nullopt;
    return ((switching.outputs >> output & 1u) == 1) == tool.tool_is_on_when;
  }
  if (!tool.lowers) return std::nullopt;
  const AxisState& axis = lowering.axes[ix(lowering_axis)];
  if (!lowering.link.connected() || !axis.position_known) return std::nullopt;
  const std::int64_t beyond = axis.position.value - tool.lowers->half_way;
  return tool.lowers->down_is_plus ? beyond > 0 : beyond < 0;
}

std::optional<bool> tool_on_now(const Frame& f, const TrackAxes& tool, const sequence::Sequence& drawn) {
  const int first = drawn.axes.empty() ? -1 : f.catalog.find_axis(drawn.axes[0].name);
  if (first < 0) return std::nullopt;
  const int lowers = tool.lowers ? tool.lowers->place : first;
  return tool_on_now(tool, owner_of(f, first).now(), owner_of(f, lowers).now(),
                     draws_together(f) ? 0 : lowers);
}

// ---- units

bool one_unit(const Frame& f, const PathSubject& s) { return s.own || one_unit(f, s.axes); }

bool one_unit(const Frame& f, const PathAxes& axes) {
  const Directions all = directions_of(f, axes);
  for (const Direction& d : all)
    if (d.unit().name != all.all[0].unit().name) return false;
  return true;
}

std::string_view unit_name(const PathSubject& s, const Direction& d) {
  return s.own ? s.own->unit : std::string_view(d.unit().name);
}

}  // namespace hw::panels
