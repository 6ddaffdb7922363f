#include "panels/path/path_overlays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "gui/model/axis_look.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "panels/path/path_backdrop.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
using drawing::Point3;

ImVec2 PathGround::at(Point3 p) const { return on_screen(in, view.to_px(p)); }

void draw_table(const PathGround& g) {
  const drawing::Box3& table = g.subject.table;
  if (table.empty) return;
  std::array<ImVec2, 4> corners;
  for (int n = 0; n < 4; ++n) {
    const ImVec2 p = g.at(table.corner(n < 2 ? n : 5 - n));  // around, not across
    corners[static_cast<std::size_t>(n)] = ImVec2(std::floor(p.x) + 0.5f, std::floor(p.y) + 0.5f);
  }
  ImGui::GetWindowDrawList()->AddPolyline(corners.data(), 4, g.frame.ui[Tone::warn], ImDrawFlags_Closed,
                                          g.frame.ui.hair());
}

/// Straight, or one axis after the other in their order.
static std::array<Point3, 4> way_there(const PathGround& g, Point3 from, Point3 to) {
  if (g.frame.catalog.can.interpolates) return {from, from, from, to};
  const PathAxes& axes = g.subject.axes;
  std::array<std::pair<int, double Point3::*>, 3> order{
      {{axes.right.index, &Point3::x}, {axes.up.index, &Point3::y}, {max_axes, &Point3::z}}};
  if (axes.third) order[2].first = axes.third->index;
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::array<Point3, 4> way{from, from, from, to};
  for (std::size_t n = 1; n < way.size(); ++n) {
    way[n] = way[n - 1];
    way[n].*order[n - 1].second = to.*order[n - 1].second;
  }
  return way;
}

void draw_lit(const PathGround& g) {
  constexpr std::size_t most_points = 4000;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Ui& ui = g.frame.ui;
  const auto here = place_now(g.frame, g.subject);
  if (here && g.subject.wanted_at) {
    for (const Point3& p : way_there(g, *here, *g.subject.wanted_at)) list->PathLineTo(g.at(p));
    list->PathStroke(ui[Tone::warn], 0, 2 * ui.hair());
    list->AddCircle(g.at(*g.subject.wanted_at), ui.px(5), ui[Tone::warn], 0, 2 * ui.hair());
  }
  if (!g.subject.path || g.subject.lit < 0) return;
  std::size_t drawn = 0;
  for (const drawing::ToolPath::Run& run : g.subject.path->runs) {
    if (run.source != g.subject.lit || drawn + run.size > most_points) continue;
    drawn += run.size;
    for (std::size_t i = run.first; i < run.first + run.size; ++i)
      list->PathLineTo(g.at(g.subject.path->points[i]));
    list->PathStroke(ui[Tone::motion], 0, 3 * ui.hair());
  }
}

void draw_trace(const PathGround& g, const drawing::ToolPath& path, std::size_t in_picture) {
  constexpr std::size_t most_drawn = 2000;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const std::size_t newer = in_picture > 2 ? in_picture - 2 : 0;
  const std::size_t from = std::max(newer, path.points.size() - std::min(path.points.size(), most_drawn));
  for (const drawing::ToolPath::Run& run : path.runs) {
    if (run.first + run.size <= from) continue;
    for (std::size_t i = std::max(run.first, from); i < run.first + run.size; ++i)
      list->PathLineTo(g.at(path.points[i]));
    list->PathStroke(g.frame.ui[Tone::motion], 0, g.frame.ui.hair());
  }
}

// ---- travel limits and home

namespace {

/// What is known of an axis' switches, as its counter counts.
struct KnownSwitches {
  std::optional<Steps> minus, plus, home_from, home_to;
};

KnownSwitches switches_of(const Frame& f, AxisId id) {
  const AxisState& axis = f.now.axes[id.index];
  if (!f.bench.present) {
    const PositionTrace::Met& met = f.tab.desk().trace.met(id);
    return {met.minus, met.plus, met.home, {}};
  }
  if (!axis.position_known || axis.in_counts) return {};
  const auto counted = [&](const std::optional<Steps>& place) {
    return place ? std::optional(*place - f.bench.load_position[id.index] + axis.position) : std::nullopt;
  };
  const SwitchPlaces& s = f.bench.switches[id.index];
  return {counted(s.minus), counted(s.plus), counted(s.home_from), counted(s.home_to)};
}

double& along(Point3& p, int direction) { return direction == 0 ? p.x : direction == 1 ? p.y : p.z; }

/// Two axes: across the whole view. Three: around what is shown, as far as that is true there.
void draw_plane(const PathGround& g, int direction, double v, ImU32 colour) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float hair = g.frame.ui.hair();
  if (g.view.flat()) {
    const ImVec2 p = g.at({v, v});
    const float x = std::floor(p.x), y = std::floor(p.y);
    return direction == 0 ? list->AddRectFilled(ImVec2(x, g.in.min.y), ImVec2(x + hair, g.in.max.y), colour)
                          : list->AddRectFilled(ImVec2(g.in.min.x, y), ImVec2(g.in.max.x, y + hair), colour);
  }
  drawing::Box3 plane = g.box;
  along(plane.low, direction) = along(plane.high, direction) = v;
  if (!g.view.projection().reaches(plane)) return;
  const int first = direction == 0 ? 2 : 1, second = direction == 2 ? 2 : 4;
  for (const int n : {0, first, first + second, second}) list->PathLineTo(g.at(plane.corner(n)));
  list->PathStroke(colour, ImDrawFlags_Closed, hair);
}

/// In the order of their directions; the last of two is -1.
std::array<int, 3> axes_of(const PathAxes& axes) {
  return {axes.right.index, axes.up.index, axes.third ? axes.third->index : -1};
}

}  // namespace

void draw_travel(const PathGround& g) {
  const Frame& f = g.frame;
  int direction = 0;
  for (const int index : axes_of(g.subject.axes)) {
    if (index < 0) break;
    const AxisId id{static_cast<std::uint8_t>(index)};
    const KnownSwitches known = switches_of(f, id);
    const auto draw = [&](const std::optional<Steps>& place, Tone tone) {
      if (place) draw_plane(g, direction, from_steps(*place, f.tab.unit(id)), f.ui[tone]);
    };
    draw(known.minus, Tone::warn), draw(known.plus, Tone::warn);
    draw(known.home_from, Tone::ok), draw(known.home_to, Tone::ok);
    ++direction;
  }
}

// ---- the tool

static Path place_words(const Frame& f, const PathAxes& axes, bool doubtful) {
  const auto written = [&f](AxisId a) {
    return format_with_unit(f.now.axes[a.index].position, f.tab.unit(a));
  };
  const Path third("{}{}", axes.third ? ", " : "",
                   axes.third ? written(*axes.third).view() : std::string_view());
  return Path("{}, {}{}{}", written(axes.right).view(), written(axes.up).view(), third.view(),
              doubtful ? "?" : "");
}

void draw_here(const PathGround& g, std::string_view id) {
  Frame& f = g.frame;
  const PathAxes& axes = g.subject.axes;
  const auto here = place_now(f, g.subject);
  if (!here) return;
  Ui& ui = f.ui;
  const auto not_sure = [&f](AxisId axis) {
    return f.now.axes[axis.index].trust.doubtful() || is_old(f.now, axis.index, f.clock);
  };
  const bool doubtful =
      !g.subject.own && (not_sure(axes.right) || not_sure(axes.up) || (axes.third && not_sure(*axes.third)));
  const ImVec2 p = g.at(*here);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImU32 colour = ui[doubtful ? Tone::ink3 : Tone::motion], faint = with_alpha(colour, 0.45f);
  if (g.view.flat()) {
    const float x = std::floor(p.x), y = std::floor(p.y);
    list->AddRectFilled(ImVec2(x, g.in.min.y), ImVec2(x + ui.hair(), g.in.max.y), faint);
    list->AddRectFilled(ImVec2(g.in.min.x, y), ImVec2(g.in.max.x, y + ui.hair()), faint);
  } else {
    const double floor = g.box.low.z;
    list->AddLine(p, g.at({here->x, here->y, floor}), faint, ui.hair());
    list->AddLine(g.at({g.box.low.x, here->y, floor}), g.at({g.box.high.x, here->y, floor}), faint,
                  ui.hair());
    list->AddLine(g.at({here->x, g.box.low.y, floor}), g.at({here->x, g.box.high.y, floor}), faint,
                  ui.hair());
  }
  list->AddCircle(p, ui.px(6), colour, 0, 2 * ui.hair());
  const Path value = g.subject.own ? Path("{}", g.subject.own->here_words) : place_words(f, axes, doubtful);
  show(ui, {Path("{}/here", id), Kind::text, "The tool is here", value},
       {ImVec2(p.x - ui.px(6), p.y - ui.px(6)), ImVec2(p.x + ui.px(6), p.y + ui.px(6))});
}

}  // namespace hw::panels
