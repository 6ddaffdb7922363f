#include "panels/path_canvas.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "core/base/index.h"
#include "gui/axis_look.h"
#include "gui/tab.h"
#include "gui/units_format.h"
#include "gui/widgets/plot.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float left_margin = 62, bottom_margin = 24, top_margin = 12, right_margin = 16;
constexpr std::size_t most_drawn = 2000;      // points of the trace in a frame: the rest is in the picture
constexpr std::size_t drawn_after = 500;      // so many new ones
constexpr std::size_t most_traced = 200'000;  // then it begins anew with what is remembered
constexpr double points_within_px = 8, a_click_within_px = 4, zoom_step = 1.25;

int decimals_of(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
}

PathLook look_of(const Ui& ui) {
  PathLook look;
  look.tool_on = ui[Tone::ink], look.tool_off = ui[Tone::ink3];
  look.on_width = 2 * ui.hair(), look.off_width = ui.hair();
  look.dash = ui.px(5), look.dash_gap = ui.px(4);
  look.arrow_every = ui.px(110), look.arrow = ui.px(9);
  return look;
}

drawing::Point where(const Tab& tab, const std::array<Steps, max_axes>& position, const PathSubject& s) {
  const auto on = [&](AxisId a) { return from_steps(position[a.index], tab.unit(a)); };
  return {on(s.right), on(s.up)};
}

std::optional<drawing::Point> where_now(const Frame& f, const PathSubject& s) {
  const AxisState &right = f.now.axes[s.right.index], &up = f.now.axes[s.up.index];
  if (!f.connected() || !right.position_known || !up.position_known) return std::nullopt;
  return drawing::Point{from_steps(right.position, f.tab.unit(s.right)),
                        from_steps(up.position, f.tab.unit(s.up))};
}

/// Path, present place and where it has been.
drawing::Box all_of(const Frame& f, const PathSubject& s, const drawing::ToolPath& trace) {
  drawing::Box box;
  if (!trace.bounds.empty) box.add(trace.bounds.low), box.add(trace.bounds.high);
  if (s.path && !s.path->bounds.empty) box.add(s.path->bounds.low), box.add(s.path->bounds.high);
  if (!s.table.empty) box.add(s.table.low), box.add(s.table.high);
  const drawing::Point here = where_now(f, s).value_or(drawing::Point());
  box.add(here);
  const bool a_point = box.low == box.high;
  const Steps around(a_point ? 1000 : 0);
  for (const Steps way : {Steps(0) - around, around})
    box.add({here.x + from_steps(way, f.tab.unit(s.right)), here.y + from_steps(way, f.tab.unit(s.up))});
  return box;
}

}  // namespace

ImVec2 PathCanvas::at(const Rect& in, drawing::Point p) const {
  const drawing::Point px = view_.to_px(p);
  // Far outside is far outside: ImGui counts in floats.
  const auto within = [](double v) { return static_cast<float>(std::clamp(v, -1e5, 1e5)); };
  return ImVec2(in.min.x + within(px.x), in.min.y + within(px.y));
}

void PathCanvas::zoom(double factor) { view_.zoom({view_.width_px() / 2, view_.height_px() / 2}, factor); }

void PathCanvas::draw(Frame& f, std::string_view id, const PathSubject& subject, float width, float height) {
  Ui& ui = f.ui;
  clicked_.reset(), passed_.reset(), clicked_place_.reset();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Rect whole{corner, ImVec2(corner.x + ui.px(width), corner.y + ui.px(height))};
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(whole.min, whole.max, ui[Tone::well]);
  const Rect in{ImVec2(corner.x + ui.px(left_margin), corner.y + ui.px(top_margin)),
                ImVec2(whole.max.x - ui.px(right_margin), whole.max.y - ui.px(bottom_margin))};
  if (in.width() >= ui.px(40) && in.height() >= ui.px(40)) {
    follow_trace(f, subject);
    place(f, subject, in);
    touch(f, id, subject, in);
    draw_again(f, subject);
    draw_grid(f, whole, in, subject);
    list->PushClipRect(in.min, in.max, true);
    draw_table(f, in, subject.table);
    draw_switches(f, in, subject);
    draw_picture(f, in);
    draw_lit(f, in, subject);
    draw_trace(f, in);
    draw_here(f, id, in, subject);
    draw_measure(f, in);
    list->PopClipRect();
    if (!subject.path && trace_.path.runs.empty())
      draw_text_in_lines(ui, {ImVec2(in.min.x + ui.px(16), in.min.y + ui.px(8)), in.max}, Face::body,
                         ui[Tone::ink2], subject.none, 4);
  }
  ImGui::SetCursorScreenPos(ImVec2(corner.x, whole.max.y));
}

void PathCanvas::place(Frame& f, const PathSubject& s, const Rect& in) {
  const DisplayUnit &right = f.tab.unit(s.right), &up = f.tab.unit(s.up);
  const bool equal = right.name == up.name;
  const bool another = s.path && s.path != fitted_to_;
  const bool resized = view_.width_px() != in.width() || view_.height_px() != in.height();
  if (!fitted_ || ((another || resized) && !moved_)) {
    view_ = drawing::PathView(all_of(f, s, trace_.path), in.width(), in.height(), equal);
    fitted_ = true;
    fitted_to_ = s.path;
  }
  view_.resize(in.width(), in.height());
}

void PathCanvas::touch(Frame& f, std::string_view id, const PathSubject& s, const Rect& in) {
  Ui& ui = f.ui;
  ImGui::SetCursorScreenPos(in.min);
  const Path value("{} {} a pixel",
                   format_number(view_.per_px().x, decimals_of(view_.per_px().x / 1000)).view(),
                   f.tab.unit(s.right).name);
  const std::string_view said = s.words.empty() ? value.view() : s.words;
  const Touch t = gui::touch(ui, {id, Kind::text, "Path", said}, ImVec2(in.width(), in.height()));
  const ImGuiIO& io = ImGui::GetIO();
  const drawing::Point mouse{io.MousePos.x - in.min.x, io.MousePos.y - in.min.y};
  if (t.started) pressed_at_ = io.MousePos;
  // How the pointer came to where it was pressed is no drag.
  if (t.held && !t.started && ImGui::IsMouseDown(0) && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0))
    view_.pan(io.MouseDelta.x, io.MouseDelta.y), moved_ = true;
  if (t.hovered && io.MouseWheel != 0) view_.zoom(mouse, std::pow(zoom_step, io.MouseWheel)), moved_ = true;
  if (t.double_clicked) fit();
  const bool stood = std::fabs(io.MousePos.x - pressed_at_.x) < a_click_within_px &&
                     std::fabs(io.MousePos.y - pressed_at_.y) < a_click_within_px;
  pointer_ = view_.from_px(mouse);
  if (t.clicked && stood) take_click(s, mouse, ui.px(points_within_px));
  if (t.ring) use_keys();
  draw_ring(ui, t);
}

void PathCanvas::use_keys() {
  constexpr double pan_px = 40;
  const ImGuiIO& io = ImGui::GetIO();
  for (const ImWchar c : io.InputQueueCharacters) {
    if (c == '+') zoom(zoom_step);
    if (c == '-') zoom(1 / zoom_step);
    if (c == '0') fit();
  }
  if (!io.KeyAlt) return;
  const auto pan = [this](int key, double right, double down) {
    if (ImGui::IsKeyPressed(key, true)) view_.pan(right * pan_px, down * pan_px), moved_ = true;
  };
  pan(GLFW_KEY_LEFT, 1, 0), pan(GLFW_KEY_RIGHT, -1, 0), pan(GLFW_KEY_UP, 0, 1), pan(GLFW_KEY_DOWN, 0, -1);
}

/// The end of a line where it is near, else the place on the path.
static drawing::Point snapped(const drawing::ToolPath& path, const drawing::PathHit& hit,
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
  const drawing::Point place = on_path ? snapped(*s.path, *on_path, view_, mouse, within) : pointer_;
  if (measure_.on) return set_end(place);
  clicked_ = on_path, clicked_place_ = place;
  if (const auto on_trace = nearest(trace_.path, view_, mouse, within))
    passed_ = {on_trace->at, trace_.first + std::chrono::seconds(trace_.path.runs[on_trace->run].source)};
}

void PathCanvas::set_end(drawing::Point end) {
  if (!measure_.from || measure_.to)
    measure_.from = end, measure_.to.reset();
  else
    measure_.to = end;
}

std::optional<drawing::Point> PathCanvas::measured() const {
  if (!measure_.from) return std::nullopt;
  const drawing::Point to = measure_.to.value_or(pointer_);
  return drawing::Point{to.x - measure_.from->x, to.y - measure_.from->y};
}

void PathCanvas::follow_trace(Frame& f, const PathSubject& s) {
  const PositionTrace& trace = f.tab.desk().trace;
  const drawing::Point scale{from_steps(Steps(1), f.tab.unit(s.right)),
                             from_steps(Steps(1), f.tab.unit(s.up))};
  const bool same = trace_.begun == trace.begun() && trace_.right == s.right && trace_.up == s.up &&
                    trace_.scale == scale && trace.count() - trace_.count <= trace.places().size() &&
                    trace_.path.points.size() < most_traced;
  const auto& places = trace.places();
  if (!same)
    trace_ = {trace.begun(),
              trace.count() - places.size(),
              s.right,
              s.up,
              scale,
              places.empty() ? Instant{} : places.front().at,
              {}};
  for (std::size_t i = places.size() - (trace.count() - trace_.count); i < places.size(); ++i)
    if (places[i].goes_on && i > 0)
      trace_.path.go(where(f.tab, places[i - 1].position, s), where(f.tab, places[i].position, s), true,
                     static_cast<int>(seconds(places[i].at - trace_.first)));
  trace_.count = trace.count();
}

void PathCanvas::draw_again(Frame& f, const PathSubject& s) {
  const PathLook look = look_of(f.ui);
  const std::size_t traced = trace_.path.points.size();
  const bool there = shown_.path == s.path && shown_.view == view_ && shown_.look == look &&
                     traced >= shown_.traced && traced < shown_.traced + drawn_after;
  if (there || under_way_) return;
  PathLook of_trace = look;
  of_trace.tool_on = f.ui[Tone::motion], of_trace.on_width = f.ui.hair(), of_trace.arrow_every = 0;
  under_way_ = true;
  Shown next{nullptr, s.path, view_, look, traced};
  f.tab.desk().worker().run(
      [next, trace = trace_.path, of_trace]() mutable {
        static const drawing::ToolPath none;
        const std::array layers{PathLayer{next.path ? next.path.get() : &none, next.look},
                                PathLayer{&trace, of_trace}};
        next.picture = std::make_shared<const Picture>(path_picture(layers, next.view));
        return next;
      },
      [this](Shown done) {
        under_way_ = false;
        shown_ = std::move(done);
      },
      alive_);
  f.ui.wake_in(0);  // without a thread it is done with the next frame
}

// ---- drawing

void PathCanvas::draw_grid(Frame& f, const Rect& whole, const Rect& in, const PathSubject& s) {
  Ui& ui = f.ui;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const drawing::Point low = view_.from_px({0, view_.height_px()}),
                       high = view_.from_px({view_.width_px(), 0});
  const auto steps = [&](double from, double to, float px, float apart) {
    return grid_step({0, static_cast<float>(to - from)}, std::max(2, static_cast<int>(px / ui.px(apart))));
  };
  const auto tone = [&](double v, double step) {
    return ui[std::fabs(v) < step * 1e-6 ? Tone::edge : Tone::line];
  };
  const double across = steps(low.x, high.x, in.width(), 90), up = steps(low.y, high.y, in.height(), 50);
  for (double v = std::ceil(low.x / across) * across; v <= high.x; v += across) {
    const float x = std::floor(at(in, {v, 0}).x);
    list->AddRectFilled(ImVec2(x, in.min.y), ImVec2(x + ui.hair(), in.max.y), tone(v, across));
    const NumberText number = format_number(v, decimals_of(across));
    const float w = std::ceil(text_width(ui, Face::small, number));
    if (x + w / 2 < whole.max.x - ui.px(52))
      draw_text(ui, ImVec2(x - w / 2, in.max.y + ui.px(4)), Face::small, ui[Tone::ink3], number);
  }
  for (double v = std::ceil(low.y / up) * up; v <= high.y; v += up) {
    const float y = std::floor(at(in, {0, v}).y);
    list->AddRectFilled(ImVec2(in.min.x, y), ImVec2(in.max.x, y + ui.hair()), tone(v, up));
    if (y > in.min.y + ui.px(20))
      draw_text_right(ui, ImVec2(in.min.x - ui.px(6), y - ui.line(Face::small) / 2), Face::small,
                      ui[Tone::ink3], format_number(v, decimals_of(up)));
  }
  const Path right("{} {}", f.catalog.axes[s.right.index].name, f.tab.unit(s.right).name);
  const Path upwards("{} {}", f.catalog.axes[s.up.index].name, f.tab.unit(s.up).name);
  draw_text_right(ui, ImVec2(in.max.x + ui.px(8), in.max.y + ui.px(4)), Face::small, ui[Tone::ink2], right);
  draw_text_line(ui, whole.min.x + ui.px(8), in.min.x - ui.px(4), in.min.y + ui.px(4), Face::small,
                 ui[Tone::ink2], upwards);
}

void PathCanvas::draw_table(Frame& f, const Rect& in, const drawing::Box& table) {
  if (table.empty) return;
  const ImVec2 low = at(in, table.low), high = at(in, table.high);
  ImGui::GetWindowDrawList()->AddRect(ImVec2(std::floor(low.x), std::floor(high.y)),
                                      ImVec2(std::floor(high.x), std::floor(low.y)), f.ui[Tone::warn], 0, 0,
                                      f.ui.hair());
}

/// Where the picture lies now: it may be of another view.
void PathCanvas::draw_picture(Frame& f, const Rect& in) {
  if (!shown_.picture) return;
  const drawing::PathView& of = shown_.view;
  const ImVec2 min = at(in, of.from_px({0, 0})), max = at(in, of.from_px({of.width_px(), of.height_px()}));
  ImGui::GetWindowDrawList()->AddImage(f.ui.pictures.show(shown_.picture), min, max);
}

void PathCanvas::draw_lit(Frame& f, const Rect& in, const PathSubject& s) {
  constexpr std::size_t most_points = 4000;
  if (!s.path || s.lit < 0) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  std::size_t drawn = 0;
  for (const drawing::ToolPath::Run& run : s.path->runs) {
    if (run.source != s.lit || drawn + run.size > most_points) continue;
    drawn += run.size;
    for (std::size_t i = run.first; i < run.first + run.size; ++i)
      list->PathLineTo(at(in, s.path->points[i]));
    list->PathStroke(f.ui[Tone::motion], 0, 3 * f.ui.hair());
  }
}

/// What is newer than the picture, and where the trace is now.
void PathCanvas::draw_trace(Frame& f, const Rect& in) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const drawing::ToolPath& path = trace_.path;
  const std::size_t newer = shown_.traced > 2 ? shown_.traced - 2 : 0;
  const std::size_t from = std::max(newer, path.points.size() - std::min(path.points.size(), most_drawn));
  for (const drawing::ToolPath::Run& run : path.runs) {
    if (run.first + run.size <= from) continue;
    for (std::size_t i = std::max(run.first, from); i < run.first + run.size; ++i)
      list->PathLineTo(at(in, path.points[i]));
    list->PathStroke(f.ui[Tone::motion], 0, f.ui.hair());
  }
}

/// Where the switches of an emulated machine are; of a real one nobody knows.
void PathCanvas::draw_switches(Frame& f, const Rect& in, const PathSubject& s) {
  if (!f.bench.present) return;
  Ui& ui = f.ui;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto line = [&](AxisId axis, const std::optional<Steps>& place, bool upright) {
    const AxisState& a = f.now.axes[axis.index];
    if (!place || !a.position_known || a.in_counts) return;
    const Steps counted = *place - f.bench.load_position[axis.index] + a.position;
    const double v = from_steps(counted, f.tab.unit(axis));
    const ImVec2 p = at(in, {v, v});
    if (upright)
      list->AddRectFilled(ImVec2(std::floor(p.x), in.min.y), ImVec2(std::floor(p.x) + ui.hair(), in.max.y),
                          ui[Tone::warn]);
    else
      list->AddRectFilled(ImVec2(in.min.x, std::floor(p.y)), ImVec2(in.max.x, std::floor(p.y) + ui.hair()),
                          ui[Tone::warn]);
  };
  for (const bool upright : {true, false}) {
    const AxisId axis = upright ? s.right : s.up;
    line(axis, f.bench.switches[axis.index].minus, upright);
    line(axis, f.bench.switches[axis.index].plus, upright);
  }
}

void PathCanvas::draw_measure(Frame& f, const Rect& in) {
  if (!measure_.on || !measure_.from) return;
  Ui& ui = f.ui;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 from = at(in, *measure_.from), to = at(in, measure_.to.value_or(pointer_));
  list->AddLine(from, to, ui[Tone::warn], ui.hair());
  for (const ImVec2 end : {from, to}) {
    const float arm = ui.px(5);
    list->AddLine(ImVec2(end.x - arm, end.y), ImVec2(end.x + arm, end.y), ui[Tone::warn], ui.hair());
    list->AddLine(ImVec2(end.x, end.y - arm), ImVec2(end.x, end.y + arm), ui[Tone::warn], ui.hair());
  }
}

void PathCanvas::draw_here(Frame& f, std::string_view id, const Rect& in, const PathSubject& s) {
  const auto here = where_now(f, s);
  if (!here) return;
  Ui& ui = f.ui;
  const auto not_sure = [&f](AxisId axis) {
    return f.now.axes[axis.index].trust.doubtful() || is_old(f.now, axis.index, f.clock);
  };
  const bool doubtful = not_sure(s.right) || not_sure(s.up);
  const ImVec2 p = at(in, *here);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImU32 colour = ui[doubtful ? Tone::ink3 : Tone::motion], faint = with_alpha(colour, 0.45f);
  const float x = std::floor(p.x), y = std::floor(p.y);
  list->AddRectFilled(ImVec2(x, in.min.y), ImVec2(x + ui.hair(), in.max.y), faint);
  list->AddRectFilled(ImVec2(in.min.x, y), ImVec2(in.max.x, y + ui.hair()), faint);
  list->AddCircle(p, ui.px(6), colour, 0, 2 * ui.hair());
  const Path value(
      "{}, {}{}", format_with_unit(f.now.axes[s.right.index].position, f.tab.unit(s.right)).view(),
      format_with_unit(f.now.axes[s.up.index].position, f.tab.unit(s.up)).view(), doubtful ? "?" : "");
  show(ui, {Path("{}/here", id), Kind::text, "The tool is here", value},
       {ImVec2(p.x - ui.px(6), p.y - ui.px(6)), ImVec2(p.x + ui.px(6), p.y + ui.px(6))});
}

}  // namespace hw::panels
