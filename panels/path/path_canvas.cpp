#include "panels/path/path_canvas.h"

#include <algorithm>
#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
using drawing::Point3;
namespace {

constexpr float left_margin = 62, bottom_margin = 24, top_margin = 12, right_margin = 16;
constexpr double points_within_px = 8, a_click_within_px = 4, zoom_step = 1.25;
constexpr double degrees_a_px = 0.4, degrees_a_key = 15;

/// The box around path, table, present position and trace, and the origin if it is shown.
drawing::Box3 all_of(const Frame& f, const PathSubject& s, const drawing::ToolPath& trace) {
  drawing::Box3 box = trace.bounds;
  for (const auto& path : {s.path, s.commanded})
    if (path) box.add(path->bounds);
  box.add(s.table);
  const Point3 here = place_now(f, s).value_or(Point3());
  box.add(here);
  if (s.wanted_at) box.add(*s.wanted_at);
  if (s.axes.third || s.origin) box.add(Point3());
  if (box.low == box.high) {
    std::array<Steps, max_axes> around;
    around.fill(Steps(1000));
    const Directions all = directions_of(f, s.axes);
    Point3 air;
    for (std::size_t n = 0; n < all.count; ++n) along(air, n) = all.all[n].place(around);
    box.add(here - air), box.add(here + air);
  }
  return box;
}

}  // namespace

void PathCanvas::zoom(double factor) { view_.zoom({view_.width_px() / 2, view_.height_px() / 2}, factor); }

/// The hint has a ground, so that no line of limit or grid goes through its words.
static void draw_hint(Ui& ui, const Rect& in, std::string_view words) {
  const Rect place{ImVec2(in.min.x + ui.px(16), in.min.y + ui.px(8)), ImVec2(in.max.x - ui.px(8), in.max.y)};
  const float width = std::min(std::ceil(text_width(ui, Face::body, words)), place.width());
  const float height =
      std::min(wrapped_height(ui, Face::body, words, place.width()), 4 * ui.line(Face::body));
  const Rect ground{ImVec2(place.min.x - ui.px(6), place.min.y - ui.px(2)),
                    ImVec2(place.min.x + width + ui.px(6), place.min.y + height + ui.px(2))};
  draw_fill(ui, ground, ui[Tone::well], 0);
  draw_text_in_lines(ui, place, Face::body, ui[Tone::ink2], words, 4);
}

void PathCanvas::draw(Frame& f, std::string_view id, const PathSubject& subject, float width, float height) {
  Ui& ui = f.ui;
  click_ = {};
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Rect whole{corner, ImVec2(corner.x + ui.px(width), corner.y + ui.px(height))};
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(whole.min, whole.max, ui[Tone::well]);
  const bool flat = !subject.axes.third;
  const float row = flat ? 0 : draw_standard_views(f, id, width);
  Rect in = view_in(ui, whole, flat, row);
  if (in.width() >= ui.px(40) && in.height() >= ui.px(40)) {
    if (!subject.own) trace_.follow(f, subject.axes);
    const KnownLimits limits = limits_of(f, subject);
    place(f, subject, limits, in);
    if (const float wide = flat ? width_of_numbers(ui, view_) / ui.scale : 0; wide > numbers_) {
      numbers_ = wide;
      in = view_in(ui, whole, flat, row);
      place(f, subject, limits, in);
    }
    touch(f, id, subject, in);
    progress_.follow(subject);
    backdrop_.follow(f, {subject, trace_.path(), view_, progress_.done(), grip_.turned});
    const PathGround ground{f, subject, view_, whole, in, all_};
    draw_grid(ground);
    list->PushClipRect(in.min, in.max, true);
    draw_table(ground);
    draw_limits(ground, limits);
    backdrop_.draw(f, in, subject, view_);
    draw_lit(ground, progress_);
    draw_way_there(ground);
    draw_origin(ground);
    draw_trace(ground, trace_.path(), backdrop_.traced(view_));
    if (subject.origin) draw_zero(ground);
    draw_here(ground, id);
    draw_measure(ground, measure_);
    list->PopClipRect();
    if (!subject.path && trace_.path().runs.empty()) draw_hint(ui, in, subject.none);
  }
  ImGui::SetCursorScreenPos(ImVec2(corner.x, whole.max.y));
}

/// The ruler on the left is as wide as its numbers, unless they leave too little width for the path.
Rect PathCanvas::view_in(const Ui& ui, const Rect& whole, bool flat, float row) const {
  constexpr float around_numbers = 14, most_of_it = 0.4f;
  const float numbers =
      std::min(std::max(left_margin, numbers_ + around_numbers), whole.width() / ui.scale * most_of_it);
  const float left = flat ? numbers : right_margin, top = flat ? top_margin : row,
              bottom = flat ? bottom_margin : right_margin;
  return {ImVec2(whole.min.x + ui.px(left), whole.min.y + ui.px(top)),
          ImVec2(whole.max.x - ui.px(right_margin), whole.max.y - ui.px(bottom))};
}

void PathCanvas::place(Frame& f, const PathSubject& s, const KnownLimits& limits, const Rect& in) {
  const bool equal = one_unit(f, s), flat = !s.axes.third;
  const bool another = s.path && s.path != fitted_to_;
  const bool resized = view_.width_px() != in.width() || view_.height_px() != in.height();
  all_ = all_of(f, s, trace_.path());
  if (with_limits_) all_ = with_limits(all_, limits);
  if (!fitted_ || flat != view_.flat() || ((another || resized) && !moved_)) {
    const auto projection = flat ? drawing::Projection() : drawing::Projection(all_, direction_, equal);
    view_ = drawing::PathView(all_, projection, in.width(), in.height(), equal || !flat);
    fitted_ = true;
    fitted_to_ = s.path;
  }
  // If the content has become larger than the distance of the viewpoint, the viewpoint moves back.
  if (!view_.projection().reaches(all_))
    view_.look(drawing::Projection(all_, direction_, equal), all_.centre());
  view_.resize(in.width(), in.height());
}

// ---- mouse and keys

void PathCanvas::touch(Frame& f, std::string_view id, const PathSubject& s, const Rect& in) {
  Ui& ui = f.ui;
  ImGui::SetCursorScreenPos(in.min);
  const Path scale("{} {} a pixel",
                   format_number(view_.per_px().x, decimals_of(view_.per_px().x / 1000)).view(),
                   unit_name(s, directions_of(f, s.axes).all[0]));
  const Path looked("turned {:.0f}, tilted {:.0f}, {}", direction_.turn, direction_.tilt, scale.view());
  const std::string_view sentence = !s.words.empty() ? s.words : view_.flat() ? scale.view() : looked.view();
  const Touch t = gui::touch(ui, {id, Kind::slider, "Path", sentence}, ImVec2(in.width(), in.height()));
  const ImGuiIO& io = ImGui::GetIO();
  const drawing::Point mouse{io.MousePos.x - in.min.x, io.MousePos.y - in.min.y};
  grip_.turned = false;
  if (t.started) {
    grip_.pressed_at = io.MousePos;
    take_pivot(s, mouse, ui.px(points_within_px));
  }
  drag(t, s);
  if (t.hovered && io.MouseWheel != 0) view_.zoom(mouse, std::pow(zoom_step, io.MouseWheel)), moved_ = true;
  if (t.double_clicked) fit();
  const bool stood = std::fabs(io.MousePos.x - grip_.pressed_at.x) < a_click_within_px &&
                     std::fabs(io.MousePos.y - grip_.pressed_at.y) < a_click_within_px;
  measure_.pointer = view_.flat() ? std::optional(view_.from_px(mouse)) : std::nullopt;
  if (t.clicked && t.hovered && stood) take_click(s, mouse, ui.px(points_within_px));
  if (ui.focus.is(id)) use_keys(s);
  draw_ring(ui, t);
}

void PathCanvas::drag(const Touch& t, const PathSubject& s) {
  const ImGuiIO& io = ImGui::GetIO();
  for (const int button : {1, 2})
    if (t.hovered && ImGui::IsMouseClicked(button)) grip_.pans_with = button;
  if (grip_.pans_with != 0 && !ImGui::IsMouseDown(grip_.pans_with)) grip_.pans_with = 0;
  // Mouse motion up to the press is not a drag.
  const bool drags = t.held && !t.started && ImGui::IsMouseDown(0);
  if ((!drags && grip_.pans_with == 0) || (io.MouseDelta.x == 0 && io.MouseDelta.y == 0)) return;
  if (grip_.pans_with != 0 || !s.axes.third || io.KeyShift) return pan(io.MouseDelta.x, io.MouseDelta.y);
  turn(-io.MouseDelta.x * degrees_a_px, io.MouseDelta.y * degrees_a_px);
}

void PathCanvas::pan(double right_px, double down_px) {
  view_.pan(right_px, down_px);
  moved_ = true;
}

void PathCanvas::turn(double turn, double tilt) {
  direction_ = {std::remainder(direction_.turn + turn, 360), std::clamp(direction_.tilt + tilt, -90.0, 90.0)};
  view_.look(view_.projection().turned(direction_), grip_.pivot);
  grip_.turned = true;
}

/// Fits the whole content, seen from that direction.
void PathCanvas::look(const drawing::ViewDirection& from) {
  direction_ = from;
  fit();
}

/// Sets the point that stays fixed while the view is turned: a point of the path near the pointer, else the
/// middle of the view.
void PathCanvas::take_pivot(const PathSubject& s, drawing::Point near_px, double within_px) {
  if (!s.axes.third) return;
  const auto hit = s.path ? nearest(*s.path, view_, near_px, within_px) : std::nullopt;
  grip_.pivot = hit ? hit->at : view_.from_px({view_.width_px() / 2, view_.height_px() / 2});
}

void PathCanvas::use_keys(const PathSubject& s) {
  constexpr double pan_px = 40;
  const ImGuiIO& io = ImGui::GetIO();
  const bool space = s.axes.third.has_value();
  for (const ImWchar c : io.InputQueueCharacters) {
    if (c == '+') zoom(zoom_step);
    if (c == '-') zoom(1 / zoom_step);
    if (c == '0') fit();
    if (c == '1') fit_limits();
    if (!space) continue;
    if (c == 't' || c == 'T') look(drawing::views::top);
    if (c == 'f' || c == 'F') look(drawing::views::front);
    if (c == 's' || c == 'S') look(drawing::views::side);
    if (c == 'i' || c == 'I') look(drawing::views::iso);
  }
  if (!io.KeyAlt) return;
  const auto arrow = [&](int key, double right, double down) {
    if (!ImGui::IsKeyPressed(key, true)) return;
    if (!space || !io.KeyShift) return pan(right * pan_px, down * pan_px);
    take_pivot(s, {}, -1);
    turn(-right * degrees_a_key, down * degrees_a_key);
  };
  arrow(GLFW_KEY_LEFT, 1, 0), arrow(GLFW_KEY_RIGHT, -1, 0), arrow(GLFW_KEY_UP, 0, 1);
  arrow(GLFW_KEY_DOWN, 0, -1);
}

/// The end of a line if it is near, else the point on the path.
static Point3 snapped(const drawing::ToolPath& path, const drawing::PathHit& hit,
                      const drawing::PathView& view, drawing::Point px, double within) {
  const drawing::ToolPath::Run& run = path.runs[hit.run];
  for (const std::size_t end : {run.first, run.first + run.size - 1}) {
    const drawing::Point at = view.to_px(path.points[end]);
    if (std::hypot(at.x - px.x, at.y - px.y) <= within) return path.points[end];
  }
  return hit.at;
}

void PathCanvas::take_click(const PathSubject& s, drawing::Point mouse, float within) {
  const auto on_path = s.path ? nearest(*s.path, view_, mouse, within) : std::nullopt;
  std::optional<Point3> place;
  if (on_path)
    place = snapped(*s.path, *on_path, view_, mouse, within);
  else if (view_.flat())
    place = view_.from_px(mouse);
  if (measure_.on) {
    if (place) measure_.set_end(*place);
    return;
  }
  click_.hit = on_path, click_.place = place;
  if (const auto on_trace = nearest(trace_.path(), view_, mouse, within))
    click_.passed = {on_trace->at, trace_.when(on_trace->run)};
}

float PathCanvas::draw_standard_views(Frame& f, std::string_view id, float width) {
  constexpr float height = 32;
  struct View {
    std::string_view name, label, tip;
    drawing::ViewDirection from;
  };
  static constexpr View views[] = {
      {"top", "Top", "From the top. On the picture: T.", drawing::views::top},
      {"front", "Front", "From the front. On the picture: F.", drawing::views::front},
      {"side", "Side", "From the right side. On the picture: S.", drawing::views::side},
      {"iso", "Iso", "From a corner. On the picture: I.", drawing::views::iso}};
  Ui& ui = f.ui;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  for (const View& v : views) {
    const ButtonOptions look{
        .style = ButtonStyle::segment, .tip = v.tip, .height = 28, .on = direction_ == v.from};
    if (button(ui, Path("{}/{}", id, v.name), v.label, look).clicked) this->look(v.from);
    ImGui::SameLine(0, 0);
  }
  const float x = ImGui::GetCursorScreenPos().x + ui.px(16);
  draw_text_line(ui, x, corner.x + ui.px(width - 8), corner.y + ui.px(height / 2), Face::small,
                 ui[Tone::ink3],
                 width < 560 ? "Drag turns, Shift moves, wheel zooms."
                             : "Drag turns it, Shift and drag moves it, the wheel zooms.");
  ImGui::SetCursorScreenPos(corner);
  return height;
}

}  // namespace hw::panels
