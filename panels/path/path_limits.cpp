#include "panels/path/path_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/model/tab.h"
#include "gui/model/units_format.h"

namespace hw::panels {

using namespace gui;
using drawing::Box3;
using drawing::Point3;

// ---- known limits

namespace {

struct Switches {
  KnownEnds limits, home;
};

Switches switches_of(const Direction& d) {
  const auto in_units = [&d](const std::optional<Steps>& place) {
    return place ? std::optional(from_steps(*place, d.unit())) : std::nullopt;
  };
  const BenchView& bench = d.tab->bench();
  if (!bench.present) {
    const PositionTrace::Met& met = d.tab->desk().records.trace.met(d.axis);
    return {{in_units(met.minus), in_units(met.plus)}, {in_units(met.home), {}}};
  }
  const AxisState& axis = *d.state();
  if (!axis.position_known || axis.in_counts) return {};
  const auto counted = [&](const std::optional<Steps>& place) {
    return place ? in_units(*place - bench.load_position[d.axis.index] + axis.position) : std::nullopt;
  };
  const SwitchPlaces& s = bench.switches[d.axis.index];
  return {{counted(s.minus), counted(s.plus)}, {counted(s.home_from), counted(s.home_to)}};
}

KnownEnds travel_of(const Direction& d) {
  const AxisState& axis = *d.state();
  if (!axis.travel_holds()) return {};
  KnownEnds ends;
  if (axis.travel.has_minus) ends.minus = from_steps(axis.travel.minus, d.unit());
  if (axis.travel.has_plus) ends.plus = from_steps(axis.travel.plus, d.unit());
  return ends;
}

}  // namespace

bool KnownLimits::any() const {
  const auto known = [](const KnownEnds& ends) { return ends.minus || ends.plus; };
  return std::any_of(travel.begin(), travel.end(), known) ||
         std::any_of(switches.begin(), switches.end(), known);
}

KnownLimits limits_of(const Frame& f, const PathSubject& s) {
  KnownLimits limits;
  if (s.own) return limits;
  const Directions all = directions_of(f, s.axes);
  for (std::size_t n = 0; n < all.count; ++n) {
    if (!all.all[n].tab) continue;
    limits.travel[n] = travel_of(all.all[n]);
    const Switches switches = switches_of(all.all[n]);
    limits.switches[n] = switches.limits, limits.home[n] = switches.home;
  }
  return limits;
}

Box3 with_limits(Box3 all, const KnownLimits& limits) {
  for (std::size_t n = 0; n < 3; ++n)
    for (const KnownEnds& ends : {limits.travel[n], limits.switches[n]})
      for (const auto& end : {ends.minus, ends.plus}) {
        if (!end) continue;
        Point3 there = all.low;
        along(there, n) = *end;
        all.add(there);
      }
  return all;
}

// ---- as lines

namespace {

/// The box of the ends in each direction, from lower to higher; where they are unknown, of `all`.
Box3 room_of(const std::array<KnownEnds, 3>& ends, const Box3& all) {
  Box3 room;
  Point3 low = all.low, high = all.high;
  for (std::size_t n = 0; n < 3; ++n) {
    if (ends[n].minus) along(low, n) = *ends[n].minus;
    if (ends[n].plus) along(high, n) = *ends[n].plus;
  }
  room.add(low), room.add(high);
  return room;
}

/// Calls `draw` for each end with the corners of its plane; with two axes the plane is a line.
template <class Draw>
void each_plane(const std::array<KnownEnds, 3>& ends, const Box3& all, bool flat, const Draw& draw) {
  const Box3 room = room_of(ends, all);
  for (std::size_t n = 0; n < (flat ? 2u : 3u); ++n)
    for (const auto& end : {ends[n].minus, ends[n].plus}) {
      if (!end) continue;
      Box3 plane = room;
      along(plane.low, n) = along(plane.high, n) = *end;
      draw(plane, n);
    }
}

std::array<Point3, 4> corners_of(const Box3& plane, std::size_t direction) {
  const int first = direction == 0 ? 2 : 1, second = direction == 2 ? 2 : 4;
  return {plane.corner(0), plane.corner(first), plane.corner(first + second), plane.corner(second)};
}

}  // namespace

drawing::ToolPath lines_of(const std::array<KnownEnds, 3>& ends, const Box3& all, bool flat) {
  drawing::ToolPath lines;
  each_plane(ends, all, flat, [&](const Box3& plane, std::size_t n) {
    if (flat) return lines.go(plane.low, plane.high, true, -1);
    const auto corners = corners_of(plane, n);
    for (std::size_t i = 0; i < 4; ++i) lines.go(corners[i], corners[(i + 1) % 4], true, -1);
  });
  return lines;
}

/// For two axes: draws a frame if all four ends are known, else lines across the view.
static void draw_ends(const PathGround& g, const std::array<KnownEnds, 3>& ends, ImU32 colour) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float hair = g.frame.ui.hair();
  Box3 all = g.box;
  if (g.view.flat()) {
    all.add(g.view.from_px({0, 0}));
    all.add(g.view.from_px({g.view.width_px(), g.view.height_px()}));
  }
  each_plane(ends, all, g.view.flat(), [&](const Box3& plane, std::size_t n) {
    if (g.view.flat()) {
      const ImVec2 a = g.at(plane.low), b = g.at(plane.high);
      const ImVec2 min(std::floor(std::min(a.x, b.x)), std::floor(std::min(a.y, b.y)));
      const ImVec2 max(std::floor(std::max(a.x, b.x)), std::floor(std::max(a.y, b.y)));
      return list->AddRectFilled(min, ImVec2(max.x + hair, max.y + hair), colour);
    }
    if (!g.view.projection().reaches(plane)) return;
    for (const Point3& corner : corners_of(plane, n)) list->PathLineTo(g.at(corner));
    list->PathStroke(colour, ImDrawFlags_Closed, hair);
  });
}

void draw_limits(const PathGround& g, const KnownLimits& limits) {
  const Ui& ui = g.frame.ui;
  draw_ends(g, limits.switches, ui[Tone::warn]);
  draw_ends(g, limits.travel, ui[Tone::warn]);
  for (std::size_t n = 0; n < 3;
       ++n) {  // each axis separately, because the home positions of two axes form no frame
    std::array<KnownEnds, 3> home;
    home[n] = limits.home[n];
    draw_ends(g, home, ui[Tone::ok]);
  }
}

void draw_zero(const PathGround& g) {
  if (!g.view.flat()) return;
  const Ui& ui = g.frame.ui;
  const ImVec2 p = g.at({});
  const float x = std::floor(p.x), y = std::floor(p.y), arm = ui.px(5), width = ui.hair();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(ImVec2(x - arm, y - width), ImVec2(x + arm + width, y + width), ui[Tone::ink]);
  list->AddRectFilled(ImVec2(x - width, y - arm), ImVec2(x + width, y + arm + width), ui[Tone::ink]);
}

}  // namespace hw::panels
