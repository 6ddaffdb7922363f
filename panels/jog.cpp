#include "panels/jog.h"

#include <algorithm>
#include <cmath>

#include "gui/area.h"
#include "gui/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/hold_button.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float between = 4;
constexpr std::string_view minus_sign = "\u2212";

struct Cell {
  float column, row;
  Icon icon;
};
/// A cross for the first two axes; the third and fourth stand as columns beside it.
Cell cell_of(AxisId axis, Sign sign) {
  const bool plus = sign == Sign::plus;
  if (axis.index == 0) return {plus ? 2.0f : 0.0f, 1, plus ? Icon::play : Icon::back};
  const float column = axis.index == 1 ? 1.0f : static_cast<float>(axis.index) + 1;
  return {column, plus ? 0.0f : 2.0f, plus ? Icon::up : Icon::down};
}

/// On a bus of one-axis controllers each row has its own two buttons.
bool jogs_in_rows(const Frame& f) { return f.tab.bus && f.catalog.axes.size() == 1; }

std::string_view limit_reason(const AxisState& a, Sign sign) {
  if (!a.limits_known) return {};
  if (sign == Sign::plus && a.limit_plus) return "It stands on its + limit. It can only move \u2212.";
  if (sign == Sign::minus && a.limit_minus) return "It stands on its \u2212 limit. It can only move +.";
  return {};
}

}  // namespace

void Jog::draw(Frame& f) {
  section_title(f.ui, "Jog", {}, 40);
  draw_reason(f);
  const std::size_t axes = f.catalog.axes.size();
  const float cell = f.tier == Tier::wide && axes <= 3 ? 56.0f : 48.0f;
  origin_ = ImGui::GetCursorScreenPos();
  follow_unit(f);
  draw_pad(f, cell);
  const float height = jogs_in_rows(f) ? 0 : axes == 1 ? cell : 3 * cell + 2 * between;
  const float pad = (axes <= 2 ? 3 : static_cast<float>(axes) + 1) * (cell + between);
  if (axes <= 2 && axes > 1) {
    const float x = pad + 12;
    draw_steps_column(f, x, f.area.width - x, height);
    ImGui::SetCursorScreenPos(ImVec2(origin_.x, origin_.y + f.ui.px(height + 12)));
  } else {
    ImGui::SetCursorScreenPos(ImVec2(origin_.x, origin_.y + f.ui.px(height + 8)));
    draw_steps_row(f);
  }
  draw_speed(f);
  group_line(f.ui, 8);
}

void Jog::draw_reason(Frame& f) {
  const std::string_view why = f.tab.why_not_move();
  if (why.empty()) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_icon(ImGui::GetWindowDrawList(), Icon::info, ImVec2(at.x + f.ui.px(6), at.y + f.ui.px(8)), f.ui.px(12),
            f.ui[Tone::ink2]);
  ImGui::SetCursorScreenPos(ImVec2(at.x + f.ui.px(20), at.y));
  wrapped(f.ui, Face::small, Tone::ink2, why, f.area.width - 20);
  ImGui::SetCursorScreenPos(ImVec2(at.x, ImGui::GetCursorScreenPos().y));
  gap(f.ui, 4);
}

void Jog::draw_pad(Frame& f, float cell) {
  if (jogs_in_rows(f)) return;
  const bool flat = f.catalog.axes.size() == 1;
  for (std::size_t i = 0; i < std::min<std::size_t>(f.catalog.axes.size(), 4); ++i)
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const AxisId axis{static_cast<std::uint8_t>(i)};
      const Cell place = cell_of(axis, sign);
      draw_button(f, axis, sign, place.column * (cell + between), (flat ? 0 : place.row) * (cell + between),
                  cell);
    }
  draw_stop(f, cell + between, flat ? 0 : cell + between, cell);
}

void Jog::draw_button(Frame& f, AxisId axis, Sign sign, float x, float y, float cell) {
  Ui& ui = f.ui;
  const std::string& name = f.catalog.axes[axis.index].name;
  const std::string_view refused = f.tab.why_not_move();
  HoldOptions o;
  o.icon = cell_of(axis, sign).icon;
  o.width = o.height = cell;
  o.disabled = refused.empty() ? limit_reason(f.now.axes[axis.index], sign) : refused;
  const auto held = f.tab.jog.control();
  o.lit = held && held->axis == axis && held->sign == sign;
  ImGui::SetCursorScreenPos(ImVec2(origin_.x + ui.px(x), origin_.y + ui.px(y)));
  const Path label("{}{}", name, sign == Sign::plus ? std::string_view("+") : minus_sign);
  const Hold hold = hold_button(ui, Path("jog/{}/{}", name, letter(sign)), label, o);
  const JogHold::Control control{JogHold::Hand::mouse, axis, sign};
  if (hold.started) f.tab.jog.press(control, {f.tab.jog_step(), f.tab.jog_speed()}, hold.pressed_at_s);
  if (hold.held) f.tab.jog.confirm(control);
  if (!hold.ended) return;
  if (o.disabled.empty())
    f.tab.jog.release(control, hold.released_at_s);
  else if (held == control)
    f.tab.jog.let_go();  // it became disabled under the hand
}

void Jog::draw_stop(Frame& f, float x, float y, float cell) {
  Ui& ui = f.ui;
  ImGui::SetCursorScreenPos(ImVec2(origin_.x + ui.px(x), origin_.y + ui.px(y)));
  const Touch t = touch(ui, {"jog/stop", Kind::button, "Stop", {}, {}, false, "Stops this controller"},
                        ui.px(cell, cell));
  if (t.hovered || t.held) draw_fill(ui, t.rect, ui[t.held ? Tone::sel : Tone::hover]);
  draw_outline(ui, t.rect, ui[Tone::fault]);
  const float middle = t.rect.centre().y;
  draw_icon(ImGui::GetWindowDrawList(), Icon::stop,
            ImVec2(std::floor(t.rect.centre().x), std::floor(middle - ui.px(10))), ui.px(12),
            ui[Tone::fault]);
  draw_text_centred(ui, {ImVec2(t.rect.min.x, middle), ImVec2(t.rect.max.x, middle + ui.px(20))},
                    Face::body_bold, ui[Tone::fault], "Stop");
  draw_ring(ui, t);
  if (t.started) f.tab.stop_all();  // on the press, not on the release
}

// ---- step

void Jog::follow_unit(Frame& f) {
  const DisplayUnit& unit = f.tab.unit(AxisId{0});
  const int many = f.tier == Tier::wide || f.catalog.axes.size() != 2 ? 5 : 4;
  if (unit == steps_unit_ && many == steps_many_ && !steps_.empty()) return;
  steps_unit_ = unit;
  steps_many_ = many;
  steps_ = jog_steps(unit, 5);
  if (many == 5) return;
  // Never drop the chosen one.
  const bool last_chosen = steps_.back().steps == f.tab.jog_step();
  steps_.erase(last_chosen ? steps_.begin() + 1 : steps_.end() - 1);
}

void Jog::draw_step(Frame& f, const JogStep& step, float width, bool short_label) {
  ButtonOptions o;
  o.on = step.steps == f.tab.jog_step();
  o.width = width;
  o.tip = step.caption.empty() ? std::string_view("A tap moves this far.") : std::string_view(step.caption);
  const bool single = step.id == "step";
  const std::string_view label = !short_label ? std::string_view(step.label)
                                 : single     ? "1 st."
                                              : std::string_view(step.id);
  if (button(f.ui, Path("jog/step/{}", step.id), label, o).clicked) {
    f.tab.profile.jog_step = step.steps;
    f.tab.profile_edited();
  }
}

void Jog::draw_steps_column(Frame& f, float x, float width, float height) {
  const float pitch = (height - 32) / static_cast<float>(steps_.size() - 1);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    ImGui::SetCursorScreenPos(
        ImVec2(origin_.x + f.ui.px(x), origin_.y + f.ui.px(std::floor(pitch * static_cast<float>(i)))));
    const bool fits = text_width(f.ui, Face::body, steps_[i].label) + f.ui.px(16) <= f.ui.px(width);
    draw_step(f, steps_[i], width, !fits);
  }
}

void Jog::draw_steps_row(Frame& f) {
  Ui& ui = f.ui;
  text(ui, Face::small, Tone::ink2, Path("A tap moves, in {}", steps_unit_.name));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float n = static_cast<float>(steps_.size());
  const float width = std::floor((std::min(f.area.width, 304.0f) - between * (n - 1)) / n);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(static_cast<float>(i) * (width + between)), at.y));
    draw_step(f, steps_[i], width, true);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(40)));
}

// ---- speed

void Jog::draw_speed(Frame& f) {
  Ui& ui = f.ui;
  const double now = f.tab.jog_speed().value > 0 ? f.tab.jog_speed().value : f.catalog.jog_speed.value;
  const NumberText words = format_speed(Pps(now), f.tab.unit(AxisId{0}));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text(ui, at, Face::body, ui[Tone::ink2],
            f.tab.jog_speed().value > 0 ? "Speed while held" : "Speed, the controller's");
  draw_text_right(ui, ImVec2(at.x + ui.px(f.area.width), at.y), Face::body_bold, ui[Tone::ink], words);
  gap(ui, 22);
  SliderOptions o;
  o.min = std::max(1.0, f.catalog.jog_speed_min.value);
  o.max = f.catalog.jog_speed_max.value;
  o.step = 1;
  o.logarithmic = true;
  o.value_text = words;
  o.width = f.area.width;
  double speed = now;
  if (slider(ui, "jog/speed", "Speed while held", speed, o)) {
    f.tab.profile.jog_speed = Pps(std::round(speed));
    f.tab.profile_edited();
  }
}

}  // namespace hw::panels
