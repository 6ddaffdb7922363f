#include "panels/control/arc_form.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr std::size_t centre_x = 0, centre_y = 1, sweep_field = 2;
constexpr std::int64_t full_turn = 360'000;
constexpr float label_column = 56, picture_width = 140, picture_height = 144, full_width = 56;

/// Draws grid lines through the centre, one usual radius apart.
void draw_arc_grid(Ui& ui, const Rect& in, ImVec2 centre) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float apart = ui.px(48);
  for (int n = -1; n <= 1; ++n) {
    const float x = centre.x + apart * static_cast<float>(n), y = centre.y + apart * static_cast<float>(n);
    list->AddRectFilled(ImVec2(x, in.min.y), ImVec2(x + ui.hair(), in.max.y), ui[Tone::line]);
    list->AddRectFilled(ImVec2(in.min.x, y), ImVec2(in.max.x, y + ui.hair()), ui[Tone::line]);
  }
}

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace

bool ArcPath::read(const Frame& f, const ActionForm& form, Arc& arc) {
  const auto x = form.entered(centre_x), y = form.entered(centre_y), sweep = form.entered(sweep_field);
  if (!x || !y || !sweep || f.now.axis_count < 2) return false;
  arc.centre_x = static_cast<double>(*x), arc.centre_y = static_cast<double>(*y);
  arc.sweep = static_cast<double>(*sweep) / 1000;
  arc.from_x = static_cast<double>(f.now.axes[0].commanded().value);
  arc.from_y = static_cast<double>(f.now.axes[1].commanded().value);
  return f.now.axes[0].position_known && f.now.axes[1].position_known;
}

/// Works only after a change, because it allocates.
void ArcPath::work_out(const Frame& f, const ActionForm& form, const Arc& arc) {
  const double radius = std::hypot(arc.from_x - arc.centre_x, arc.from_y - arc.centre_y);
  const double length = radius * std::abs(radians(arc.sweep));
  const DisplayUnit& unit = f.tab.settings.unit(AxisId{0});
  const bool same =
      unit == f.tab.settings.unit(AxisId{1}) && !f.now.axes[0].in_counts && !f.now.axes[1].in_counts;
  const DisplayUnit own{f.now.axes[0].in_counts ? f.catalog.loop_word : f.catalog.step_word};
  const DisplayUnit& in = same ? unit : own;
  words_ = fmt::format("Radius {}, {} of arc", format_with_unit(Steps(std::llround(radius)), in).view(),
                       format_with_unit(Steps(std::llround(length)), in).view());
  if (const double speed = f.now.axes[0].own_speed.value; speed > 0)
    words_ += fmt::format(", about {}", format_duration(length / speed).view());
  const auto& reaches = f.catalog.actions[static_cast<std::size_t>(form.action())].reaches;
  inside_ = true;
  bool bounded = false;
  if (reaches)
    for (const AxisTarget& place :
         reaches(f.now, {*form.entered(centre_x), *form.entered(centre_y), *form.entered(sweep_field)})) {
      const AxisState& a = f.now.axes[place.axis.index];
      if (!a.travel_holds()) continue;
      bounded = true;
      for (const Sign side : {Sign::minus, Sign::plus})
        if (a.travel.past(side, place.value).value > 0) inside_ = false;
    }
  words_ += !inside_ ? ". It leaves the limits." : bounded ? ". Inside the limits." : ".";
}

void ArcPath::draw(Frame& f, ActionForm& form, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ActionInfo& info = f.catalog.actions[static_cast<std::size_t>(form.action())];
  const bool picture = width >= 320;
  const float left = picture ? width - picture_width - 12 : width;
  const float field = std::floor((left - label_column - close_between) / 2);
  const auto row = [&](float y, std::string_view label) {
    draw_text_line(ui, at.x, at.x + ui.px(label_column), std::floor(at.y + ui.px(y + 16)), Face::body,
                   ui[Tone::ink2], label);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(label_column), at.y + ui.px(y)));
  };
  const auto right_half = [&](float y) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(label_column + field + close_between), at.y + ui.px(y)));
  };
  row(0, "Centre");
  form.draw_bare_field(f, centre_x, field);
  right_half(0);
  form.draw_bare_field(f, centre_y, field);
  row(36, "Sweep");
  form.draw_bare_field(f, sweep_field, field);
  right_half(36);
  ButtonOptions full;
  full.width = std::min(field, full_width);
  full.tip = "A full circle, in the direction of the sign.";
  if (button(ui, Path("action/{}/full", info.id), "Full", full).clicked) {
    const auto now = form.entered(sweep_field);
    form.put(sweep_field, now && *now < 0 ? -full_turn : full_turn);
  }
  Arc arc;
  const bool known = read(f, form, arc);
  const Travel travel[2] = {f.now.axes[0].travel, f.now.axes[1].travel};
  if (known && (!known_ || !(arc == arc_) || !(travel[0] == travel_[0]) || !(travel[1] == travel_[1]))) {
    arc_ = arc, travel_[0] = travel[0], travel_[1] = travel[1];
    work_out(f, form, arc);
  }
  known_ = known;
  const bool turns = known && std::hypot(arc.from_x - arc.centre_x, arc.from_y - arc.centre_y) >= 1;
  const std::string_view words = turns   ? std::string_view(words_)
                                 : known ? "Choose another centre: the axes stand at this one."
                                         : "Enter three numbers to draw it.";
  const Rect line{ImVec2(at.x, at.y + ui.px(74)), ImVec2(at.x + ui.px(left), at.y + ui.px(108))};
  draw_text_in_lines(ui, line, Face::small, ui[inside_ || !known ? Tone::ink2 : Tone::warn], words, 2);
  show(ui, {Path("action/{}/path", info.id), Kind::text, info.label, words, {}, false, info.help}, line);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(112)));
  form.draw_button(f, 0);
  if (picture)
    draw_path(f, {ImVec2(at.x + ui.px(width - picture_width), at.y),
                  ImVec2(at.x + ui.px(width), at.y + ui.px(picture_height))});
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(arc_height)));
  form.draw_refusal(f, width);
}

void ArcPath::draw_path(Frame& f, const Rect& in) const {
  Ui& ui = f.ui;
  ImDrawList* list = ImGui::GetWindowDrawList();
  draw_fill(ui, in, ui[Tone::well], 0);
  const double radius = std::hypot(arc_.from_x - arc_.centre_x, arc_.from_y - arc_.centre_y);
  const ImVec2 c(std::floor(in.centre().x), std::floor(in.centre().y));
  draw_arc_grid(ui, in, c);
  if (known_ && radius < 1) list->AddCircle(c, ui.px(5), ui[Tone::motion], 0, ui.px(2));
  if (!known_ || radius < 1) return;
  list->PushClipRect(in.min, in.max, true);
  const float r = ui.px(48);
  const double scale = r / radius;
  const auto at_angle = [&](double angle) {
    return ImVec2(c.x + r * static_cast<float>(std::cos(angle)),
                  c.y - r * static_cast<float>(std::sin(angle)));
  };
  // Draws the limits of the axes inside the picture.
  for (int axis = 0; axis < 2; ++axis) {
    const AxisState& a = f.now.axes[static_cast<std::size_t>(axis)];
    for (const Sign side : {Sign::minus, Sign::plus}) {
      if (!a.travel_holds() || !a.travel.has(side)) continue;
      const double off =
          static_cast<double>(a.travel.end(side).value) - (axis == 0 ? arc_.centre_x : arc_.centre_y);
      const auto place = static_cast<float>(std::clamp(off * scale, -1e4, 1e4));
      const ImVec2 from = axis == 0 ? ImVec2(c.x + place, in.min.y) : ImVec2(in.min.x, c.y - place);
      const ImVec2 to = axis == 0 ? ImVec2(c.x + place, in.max.y) : ImVec2(in.max.x, c.y - place);
      list->AddLine(from, to, ui[Tone::warn], ui.hair());
    }
  }
  const double begin = std::atan2(arc_.from_y - arc_.centre_y, arc_.from_x - arc_.centre_x);
  const double turn = radians(arc_.sweep);
  constexpr int dashes = 36, steps = 48;
  for (int i = 0; i < dashes; ++i) {
    const double from = 2 * std::numbers::pi * i / dashes;
    list->AddLine(at_angle(from), at_angle(from + std::numbers::pi / dashes), ui[Tone::edge], ui.hair());
  }
  for (int i = 0; i < steps; ++i)
    list->AddLine(at_angle(begin + turn * i / steps), at_angle(begin + turn * (i + 1) / steps), ui[Tone::ink],
                  ui.px(2));
  list->AddLine(ImVec2(c.x - ui.px(4), c.y), ImVec2(c.x + ui.px(4), c.y), ui[Tone::ink3], ui.hair());
  list->AddLine(ImVec2(c.x, c.y - ui.px(4)), ImVec2(c.x, c.y + ui.px(4)), ui[Tone::ink3], ui.hair());
  const ImVec2 start = at_angle(begin), end = at_angle(begin + turn), mid = at_angle(begin + turn * 0.5);
  list->AddCircle(start, ui.px(5), ui[Tone::motion], 0, ui.px(2));
  const float half = ui.px(3);
  list->AddRectFilled(ImVec2(end.x - half, end.y - half), ImVec2(end.x + half, end.y + half), ui[Tone::ink]);
  // Draws the direction of travel in the middle of the arc.
  const double heading = begin + turn * 0.5 + (turn < 0 ? -1 : 1) * std::numbers::pi / 2;
  const auto tip = [&](double angle, float far) {
    return ImVec2(mid.x + far * static_cast<float>(std::cos(angle)),
                  mid.y - far * static_cast<float>(std::sin(angle)));
  };
  list->AddTriangleFilled(tip(heading, ui.px(5)), tip(heading + 2.3, ui.px(5)), tip(heading - 2.3, ui.px(5)),
                          ui[Tone::ink]);
  list->PopClipRect();
}

}  // namespace hw::panels
