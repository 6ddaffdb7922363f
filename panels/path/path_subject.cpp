#include "panels/path/path_subject.h"

#include <algorithm>

#include <fmt/format.h>

#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "panels/drawing/drawn_together.h"

namespace hw::panels {

using namespace gui;
using drawing::Point3;

// ---- directions

const DisplayUnit& Direction::unit() const {
  static const DisplayUnit of_time{"s", 0.001, 2, true};
  return tab ? tab->unit(axis) : of_time;
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

// ---- where it is

Instant zero_of_time(const Tab& tab) {
  const Instant begun = tab.now().program.started_at;
  return begun != Instant{} ? begun : const_cast<Tab&>(tab).desk().trace.first_at();
}

/// Time goes as far as the axis has moved: at rest nothing is drawn anew.
static double seconds_now(Tab& tab) {
  const auto& places = tab.desk().trace.places();
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
