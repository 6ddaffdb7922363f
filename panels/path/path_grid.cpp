// Draws the grid of a path: rulers for two axes, the floor for three.
#include <algorithm>
#include <cmath>

#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/plot.h"
#include "gui/widgets/text.h"
#include "panels/path/path_overlays.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
using drawing::Point3;

int decimals_of(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
}

double step_over(double range, float px, float apart_px) {
  return grid_step({0, static_cast<float>(range)}, std::max(2, static_cast<int>(px / apart_px)));
}

namespace {

double step_up(const Ui& ui, const drawing::PathView& view) {
  const double range = view.from_px({0, 0}).y - view.from_px({0, view.height_px()}).y;
  return step_over(range, static_cast<float>(view.height_px()), ui.px(50));
}

bool is_zero(double v, double step) { return std::fabs(v) < step * 1e-6; }

Path axis_and_unit(const PathGround& g, std::size_t direction) {
  const Directions all = directions_of(g.frame, g.subject.axes);
  const Direction& d = all.all[direction];
  return Path("{} {}", d.name, unit_name(g.subject, d));
}

void draw_rulers(const PathGround& g) {
  const Frame& f = g.frame;
  Ui& ui = f.ui;
  const Rect &in = g.in, &whole = g.whole;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Point3 low = g.view.from_px({0, g.view.height_px()}), high = g.view.from_px({g.view.width_px(), 0});
  const auto tone = [&](double v, double step) { return ui[is_zero(v, step) ? Tone::edge : Tone::line]; };
  const double across = step_over(high.x - low.x, in.width(), ui.px(90)), up = step_up(ui, g.view);
  const float name_begins = whole.max.x - text_width(ui, Face::small, axis_and_unit(g, 0)) - ui.px(16);
  for (double v = std::ceil(low.x / across) * across; v <= high.x; v += across) {
    const float x = std::floor(g.at({v, 0}).x);
    list->AddRectFilled(ImVec2(x, in.min.y), ImVec2(x + ui.hair(), in.max.y), tone(v, across));
    const NumberText number = format_number(v, decimals_of(across));
    const float w = std::ceil(text_width(ui, Face::small, number));
    if (x + w / 2 < name_begins)
      draw_text(ui, ImVec2(x - w / 2, in.max.y + ui.px(4)), Face::small, ui[Tone::ink3], number);
  }
  for (double v = std::ceil(low.y / up) * up; v <= high.y; v += up) {
    const float y = std::floor(g.at({0, v}).y);
    list->AddRectFilled(ImVec2(in.min.x, y), ImVec2(in.max.x, y + ui.hair()), tone(v, up));
    if (y > in.min.y + ui.px(20))
      draw_text_right(ui, ImVec2(in.min.x - ui.px(6), y - ui.line(Face::small) / 2), Face::small,
                      ui[Tone::ink3], format_number(v, decimals_of(up)));
  }
  draw_text_right(ui, ImVec2(in.max.x + ui.px(8), in.max.y + ui.px(4)), Face::small, ui[Tone::ink2],
                  axis_and_unit(g, 0));
  const float upwards = whole.min.x + ui.px(8);  // the name may reach into the picture
  draw_text_line(ui, upwards, upwards + in.width() / 2, in.min.y + ui.px(4), Face::small, ui[Tone::ink2],
                 axis_and_unit(g, 1));
}

float distance(ImVec2 a, ImVec2 b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// Draws rungs across the edge from `from` to `to`, along which a coordinate goes from `low` to `high`. Each
/// rung is as long as `rung`, with its number at its beginning.
void draw_rungs(const PathGround& g, Point3 from, Point3 to, double low, double high, Point3 rung) {
  constexpr float apart = 70;
  Ui& ui = g.frame.ui;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float px = distance(g.at(from), g.at(to));
  if (!(high > low) || px < ui.px(apart) / 2) return;
  const double step = step_over(high - low, std::min(px, ui.px(20 * apart)), ui.px(apart));
  // The numbers are on the side without rungs.
  const ImVec2 end = g.at(from + rung), begin = g.at(from);
  const float aside = end.x > begin.x + 1 ? -1.0f : end.x < begin.x - 1 ? 1.0f : -1.0f;
  for (double v = std::ceil(low / step) * step; v <= high; v += step) {
    const Point3 at = from + (to - from) * ((v - low) / (high - low));
    const ImVec2 p = g.at(at);
    list->AddLine(p, g.at(at + rung), ui[is_zero(v, step) ? Tone::edge : Tone::line], ui.hair());
    const NumberText number = format_number(v, decimals_of(step));
    const float w = std::ceil(text_width(ui, Face::small, number)), h = ui.line(Face::small);
    draw_text(ui, ImVec2(std::floor(p.x + aside * ui.px(6) - (aside < 0 ? w : 0)), std::floor(p.y - h / 4)),
              Face::small, ui[Tone::ink3], number);
  }
}

void draw_floor(const PathGround& g) {
  const drawing::Box3& b = g.box;
  const double z = b.low.z;
  const auto lower = [&](Point3 a, Point3 c) { return g.at(a).y >= g.at(c).y; };
  const Point3 middle = b.centre();
  // The edges nearer to the viewer are further down.
  const bool near_y = lower({middle.x, b.low.y, z}, {middle.x, b.high.y, z});
  const bool near_x = lower({b.low.x, middle.y, z}, {b.high.x, middle.y, z});
  const double y = near_y ? b.low.y : b.high.y, far_y = near_y ? b.high.y : b.low.y;
  const double x = near_x ? b.low.x : b.high.x, far_x = near_x ? b.high.x : b.low.x;
  draw_rungs(g, {b.low.x, y, z}, {b.high.x, y, z}, b.low.x, b.high.x, {0, far_y - y, 0});
  draw_rungs(g, {x, b.low.y, z}, {x, b.high.y, z}, b.low.y, b.high.y, {far_x - x, 0, 0});
  Point3 left{b.low.x, b.low.y, z};
  for (int n = 0; n < 4; ++n)
    if (g.at(b.corner(n)).x < g.at(left).x) left = b.corner(n);
  Point3 top = left;
  top.z = b.high.z;
  ImGui::GetWindowDrawList()->AddLine(g.at(left), g.at(top), g.frame.ui[Tone::line], g.frame.ui.hair());
  draw_rungs(g, left, top, b.low.z, b.high.z, {});
}

}  // namespace

float width_of_numbers(const Ui& ui, const drawing::PathView& view) {
  const double up = step_up(ui, view);
  float widest = 0;
  for (const double edge : {std::ceil(view.from_px({0, view.height_px()}).y / up) * up,
                            std::floor(view.from_px({0, 0}).y / up) * up})
    widest = std::max(widest, text_width(ui, Face::small, format_number(edge, decimals_of(up))));
  return std::ceil(widest);
}

void draw_origin(const PathGround& g) {
  if (g.view.flat()) return;
  constexpr double part = 0.25;  // part of the whole content
  const Frame& f = g.frame;
  const Point3 size = g.box.size();
  const double reach = std::max({size.x, size.y, size.z}) * part;
  const auto arm = [&](Point3 end, std::size_t direction) {
    const ImVec2 from = g.at({}), to = g.at(end);
    ImGui::GetWindowDrawList()->AddLine(from, to, f.ui[Tone::ink2], 2 * f.ui.hair());
    const float length = distance(from, to);
    if (length < f.ui.px(12) || (!g.in.contains(from) && !g.in.contains(to))) return;
    // The name of the axis continues at the end of the edge.
    const Path name = axis_and_unit(g, direction);
    const float w = std::ceil(text_width(f.ui, Face::small, name)), h = f.ui.line(Face::small);
    if (w > g.in.width() || h > g.in.height()) return;
    const ImVec2 way((to.x - from.x) / length, (to.y - from.y) / length);
    const ImVec2 middle(to.x + way.x * (w / 2 + f.ui.px(6)), to.y + way.y * (h / 2 + f.ui.px(4)));
    const ImVec2 corner(std::floor(std::clamp(middle.x - w / 2, g.in.min.x, g.in.max.x - w)),
                        std::floor(std::clamp(middle.y - h / 2, g.in.min.y, g.in.max.y - h)));
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(corner.x - f.ui.px(2), corner.y),
                                              ImVec2(corner.x + w + f.ui.px(2), corner.y + h),
                                              f.ui[Tone::well]);
    draw_text(f.ui, corner, Face::small, f.ui[Tone::ink2], name);
  };
  arm({reach, 0, 0}, 0);
  arm({0, reach, 0}, 1);
  arm({0, 0, reach}, 2);
}

void draw_grid(const PathGround& g) {
  if (g.view.flat()) return draw_rulers(g);
  ImGui::PushClipRect(g.in.min, g.in.max, true);
  draw_floor(g);
  ImGui::PopClipRect();
}

}  // namespace hw::panels
