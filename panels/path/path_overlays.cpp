#include "panels/path/path_overlays.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gui/model/axis_look.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "panels/path/path_backdrop.h"
#include "panels/path/path_trace.h"
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
    const ImVec2 p = g.at(table.corner(n < 2 ? n : 5 - n));  // along the edges, not across
    corners[static_cast<std::size_t>(n)] = ImVec2(std::floor(p.x) + 0.5f, std::floor(p.y) + 0.5f);
  }
  ImGui::GetWindowDrawList()->AddPolyline(corners.data(), 4, g.frame.ui[Tone::warn], ImDrawFlags_Closed,
                                          g.frame.ui.hair());
}

/// The way there: straight, or one axis after the other in their order.
static std::array<Point3, 4> way_there(const PathGround& g, Point3 from, Point3 to) {
  std::array<Point3, 4> way{from, from, from, to};
  if (g.frame.catalog.can.interpolates) return way;
  const Directions all = directions_of(g.frame, g.subject.axes);
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.begin() + all.count,
            [&](std::size_t a, std::size_t b) { return all.all[a].axis.index < all.all[b].axis.index; });
  for (std::size_t n = 1; n < way.size(); ++n) {
    way[n] = way[n - 1];
    along(way[n], order[n - 1]) = along(to, order[n - 1]);
  }
  return way;
}

void draw_way_there(const PathGround& g) {
  const auto here = place_now(g.frame, g.subject);
  if (!here || !g.subject.wanted_at) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Ui& ui = g.frame.ui;
  for (const Point3& p : way_there(g, *here, *g.subject.wanted_at)) list->PathLineTo(g.at(p));
  list->PathStroke(ui[Tone::warn], 0, 2 * ui.hair());
  list->AddCircle(g.at(*g.subject.wanted_at), ui.px(5), ui[Tone::warn], 0, 2 * ui.hair());
}

namespace {

/// Points of a path, optionally with a place before or after them.
struct PathPart {
  std::size_t first = 0, end = 0;
  std::optional<Point3> before = {}, behind = {};
};

/// Draws few lines, so that a frame is not delayed. Two coincident points would spoil the line end.
void stroke(const PathGround& g, const PathPart& part, Tone tone, float width) {
  constexpr std::size_t most_lines = 4000;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const std::vector<Point3>& points = g.subject.path->points;
  if (part.before) list->PathLineToMergeDuplicate(g.at(*part.before));
  const std::size_t every = 1 + (part.end - std::min(part.end, part.first)) / most_lines;
  for (std::size_t i = part.first; i < part.end; i += every) list->PathLineToMergeDuplicate(g.at(points[i]));
  if (part.behind)
    list->PathLineToMergeDuplicate(g.at(*part.behind));
  else if (part.end > part.first)
    list->PathLineToMergeDuplicate(g.at(points[part.end - 1]));
  list->PathStroke(g.frame.ui[tone], 0, width);
}

}  // namespace

void draw_lit(const PathGround& g, PathProgress& progress) {
  constexpr std::size_t most_runs = 2000;
  if (!g.subject.path) return;
  const auto here = place_now(g.frame, g.subject);
  const auto reached = here ? progress.reached(g.view, *here, g.frame.ui.px(40)) : std::nullopt;
  std::size_t drawn = 0;
  for (const PathProgress::RunRange& range : progress.lit())
    for (std::size_t r = range.first; r < range.end && drawn < most_runs; ++r, ++drawn) {
      const drawing::ToolPath::Run& run = g.subject.path->runs[r];
      const std::size_t end = run.first + run.size;
      const float width = (run.tool_on ? 3.0f : 1.5f) * g.frame.ui.hair();
      const std::size_t next = reached ? reached->next_point : end;
      if (next <= run.first) {
        stroke(g, {run.first, end}, Tone::ink3, width);
      } else if (next >= end) {
        stroke(g, {run.first, end}, Tone::motion, width);
      } else {
        stroke(g, {next, end, reached->at}, Tone::ink3, width);
        stroke(g, {run.first, next, {}, reached->at}, Tone::motion, width);
      }
    }
}

void draw_trace(const PathGround& g, const drawing::ToolPath& path, std::size_t in_picture) {
  constexpr std::size_t most_drawn = 2000;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const std::size_t newer = in_picture > 2 ? in_picture - 2 : 0;
  const std::size_t from = std::max(newer, path.points.size() - std::min(path.points.size(), most_drawn));
  const TraceAges ages = ages_of(path);
  std::size_t age = TraceAges::count - 1;
  for (std::size_t r = path.runs.size(); r-- > 0;) {
    const drawing::ToolPath::Run& run = path.runs[r];
    if (run.first + run.size <= from) break;
    while (age > 0 && r < ages.begin[age]) --age;
    for (std::size_t i = std::max(run.first, from); i < run.first + run.size; ++i)
      list->PathLineTo(g.at(path.points[i]));
    list->PathStroke(trace_colour(g.frame.ui, age), 0, trace_width(g.frame.ui, age));
  }
}

// ---- the tool

static Path place_words(const Directions& all, Point3 here, bool doubtful) {
  std::array<NumberText, 3> places;
  for (std::size_t n = 0; n < all.count; ++n) {
    const DisplayUnit& unit = all.all[n].unit();
    places[n] = format_with_unit(to_steps(along(here, n), unit), unit);
  }
  return Path("{}, {}{}{}{}", places[0].view(), places[1].view(), all.count > 2 ? ", " : "", places[2].view(),
              doubtful ? "?" : "");
}

void draw_here(const PathGround& g, std::string_view id) {
  Frame& f = g.frame;
  const auto here = place_now(f, g.subject);
  if (!here) return;
  Ui& ui = f.ui;
  const Directions all = directions_of(f, g.subject.axes);
  const auto not_sure = [](const Direction& d) {
    return d.tab && (d.state()->trust.doubtful() || is_old(d.tab->now(), d.axis.index, d.tab->clock()));
  };
  const bool doubtful = !g.subject.own && std::any_of(all.begin(), all.end(), not_sure);
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
  const std::optional<bool>& tool_on = g.subject.tool_on;
  if (tool_on.value_or(false)) list->AddCircleFilled(p, ui.px(4), ui[Tone::warn]);
  list->AddCircle(p, ui.px(tool_on.value_or(false) ? 7 : 6), colour, 0, 2 * ui.hair());
  const Path place =
      g.subject.own ? Path("{}", g.subject.own->here_words) : place_words(all, *here, doubtful);
  const Path value("{}{}", place.view(), !tool_on ? "" : *tool_on ? ", tool on" : ", tool off");
  show(ui, {Path("{}/here", id), Kind::text, "The tool is here", value},
       {ImVec2(p.x - ui.px(6), p.y - ui.px(6)), ImVec2(p.x + ui.px(6), p.y + ui.px(6))});
}

}  // namespace hw::panels
