#include "panels/jog/jog_speed.h"

#include <algorithm>
#include <cmath>

#include "gui/model/jog_choice.h"
#include "gui/model/tap_size.h"
#include "gui/widgets/button.h"
#include "gui/widgets/popup.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/jog/jog_units.h"
#include "panels/position/position_words.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float slider_height = 32, number_height = 26, speed_number_width = 112;  // whatever its text
constexpr float speeds_width = 276, speeds_side = 12, speeds_row = 32;

/// The controllers' own speed of the axes.
struct OwnSpeed {
  bool alike = true;  ///< the same for all axes
  Pps speed{};        ///< the highest; 0: unknown yet
};
OwnSpeed own_speed(const Frame& f) {
  bool any_on = false, known = true;
  OwnSpeed own;
  for_each_axis(f, [&](const Tab& tab, AxisId id) { any_on = any_on || tab.now().axes[id.index].enabled; });
  for_each_axis(f, [&](const Tab& tab, AxisId id) {
    const AxisState& axis = tab.now().axes[id.index];
    const LinkState link = tab.now().link.state;
    if (link != LinkState::good && link != LinkState::late) return;
    if (any_on && !axis.enabled) return;
    known = known && axis.own_speed.value > 0;
    own.alike = own.alike && (own.speed.value <= 0 || own.speed == axis.own_speed);
    own.speed = std::max(own.speed, axis.own_speed);
  });
  return known ? own : OwnSpeed();
}

/// The user's choice for all axes.
struct ChosenSpeed {
  bool any = false;   ///< false: each axis has the controller's own speed
  bool alike = true;  ///< the same for all axes
  Pps speed{};        ///< the highest speed used
};
ChosenSpeed chosen_speed(const Frame& f) {
  ChosenSpeed chosen;
  bool first = true;
  Pps before{};
  for_each_axis(f, [&](const Tab& tab, AxisId axis) {
    const Pps speed = tab.settings.jog_speed(axis);
    chosen.any = chosen.any || speed.value > 0;
    chosen.alike = chosen.alike && (first || speed == before);
    chosen.speed = std::max(chosen.speed, held_speed(tab, axis));
    before = speed, first = false;
  });
  return chosen;
}

bool by_itself(const Frame& f) { return !chosen_speed(f).any; }
/// Whether the units or the speeds of the axes differ, so that speeds are shown and typed for each axis.
bool by_axis(const Frame& f) {
  if (unit_of_taps(f.tab)) return true;
  const ChosenSpeed chosen = chosen_speed(f);
  return chosen.any ? !chosen.alike : !own_speed(f).alike;
}

constexpr std::string_view different_speeds = "each its own";

NumberText speed_in_words(const Frame& f) {
  const ChosenSpeed chosen = chosen_speed(f);
  const Pps speed = chosen.any ? chosen.speed : own_speed(f).speed;
  NumberText words;
  if (by_axis(f)) return words.append(different_speeds), words;
  if (speed.value <= 0) return words.append("not known yet"), words;
  return format_speed(speed, common_unit(f));
}

double slowest(const Frame& f) { return std::max(1.0, f.catalog.jog_speed_min.value); }
double fastest(const Frame& f) { return f.catalog.jog_speed_max.value; }

/// The controller's own speed, if known.
double usual(const Frame& f) {
  const OwnSpeed own = own_speed(f);
  const double speed = own.speed.value > 0 ? own.speed.value : f.catalog.jog_speed.value;
  return std::clamp(speed, slowest(f), fastest(f));
}

void choose(Frame& f, double speed) {
  const double requested = std::clamp(std::round(speed), slowest(f), fastest(f));
  choose_jog_speed(f.tab, Pps(requested == std::round(usual(f)) ? 0 : requested));
}

double per_step(const DisplayUnit& unit) { return unit.real ? unit.per_step : 1; }

}  // namespace

namespace {

/// Draws the number right-aligned. A narrow place gets it without the unit, which the positions show too.
void draw_number_words(const Frame& f, const Rect& r, std::string_view words) {
  const Ui& ui = f.ui;
  const auto fits = [&](std::string_view s) { return text_width(ui, Face::body_bold, s) <= r.width(); };
  NumberText brief;
  const Pps speed = by_itself(f) ? own_speed(f).speed : chosen_speed(f).speed;
  if (!fits(words) && words != different_speeds && speed.value > 0)
    brief = format_brief_speed(speed, common_unit(f));
  const std::string_view shown = brief.view().empty() ? words : brief.view();
  const float width = std::min(r.width(), std::ceil(text_width(ui, Face::body_bold, shown)));
  draw_text_line(ui, r.max.x - width, r.max.x + 1, r.centre().y, Face::body_bold, ui[Tone::ink], shown);
}

}  // namespace

void JogSpeed::draw_slider(Frame& f, float width) {
  const NumberText words = speed_in_words(f);
  SliderOptions o;
  o.min = slowest(f);
  o.max = fastest(f);
  o.step = 1;
  o.logarithmic = true;
  o.normal = usual(f);
  o.tip = !by_itself(f)        ? "Speed while held. Double-click for the controller's own."
          : own_speed(f).alike ? "Speed while held: the controller's own. Drag to choose another."
                               : "Speed while held: each axis has its own. Drag to choose one for all.";
  if (unit_of_taps(f.tab))
    o.tip =
        "Speed while held, in steps per second, the same for all axes. Click the words beside it to choose a "
        "speed for each axis in its own unit.";
  o.value_text = words;
  o.width = width;
  double speed = by_itself(f) ? o.normal : chosen_speed(f).speed.value;
  if (slider(f.ui, "jog/speed", "Speed while held", speed, o)) choose(f, speed);
}

void JogSpeed::begin_typing(Frame& f) {
  const DisplayUnit& unit = common_unit(f);
  const double speed = by_itself(f) ? usual(f) : chosen_speed(f).speed.value;
  field_.set(speed * per_step(unit), unit.real ? unit.decimals : 0);
  typing_ = true;
  was_typing_ = false;
  type_into(f.ui, "jog/speed/field");
}

/// Draws the number at the right end of its place. A click turns it into a field.
void JogSpeed::draw_number(Frame& f, ImVec2 at, float width, float height) {
  Ui& ui = f.ui;
  ImGui::SetCursorScreenPos(at);
  if (typing_) return draw_field(f, width, height);
  const NumberText words = speed_in_words(f);
  const Touch t = touch(ui,
                        {"jog/speed/number",
                         Kind::button,
                         "Type the speed",
                         words,
                         {},
                         false,
                         by_axis(f) ? "Speed while held, of each axis. Click to change them."
                                    : "Speed while held. Click to type another."},
                        ImVec2(ui.px(width), ui.px(height)));
  draw_axes(f, by_axis(f) ? t : Touch());
  const float around = ui.px(4);
  if (t.hovered || t.held)
    draw_fill(ui, {t.rect.min, ImVec2(t.rect.max.x + around, t.rect.max.y)}, ui[Tone::hover]);
  draw_number_words(f, t.rect, words);
  draw_ring(ui, t);
  if (t.clicked && !by_axis(f)) begin_typing(f);
}

/// Draws a row for each axis: "X [12.000] mm/s  Reset".
void JogSpeed::draw_axes(Frame& f, const Touch& opener) {
  int axes = 0;
  for_each_axis(f, [&](const Tab&, AxisId) { ++axes; });
  if (!begin_popup(f.ui, "jog/speeds", opener, speeds_width, static_cast<float>(axes) + 1, true)) return;
  fields_.resize(static_cast<std::size_t>(axes));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(f.ui, at.x + f.ui.px(speeds_side), at.x + f.ui.px(speeds_width),
                 at.y + f.ui.px(speeds_row / 2), Face::body_bold, f.ui[Tone::ink], "Speed while held");
  float y = at.y + f.ui.px(speeds_row);
  auto field = fields_.begin();
  for_each_axis(f, [&](Tab& tab, AxisId axis) {
    ImGui::SetCursorScreenPos(ImVec2(at.x, y));
    draw_axis(f, tab, axis, *field++);
    y += f.ui.px(speeds_row);
  });
  ImGui::SetCursorScreenPos(ImVec2(at.x, y));
  end_popup();
}

void JogSpeed::draw_axis(Frame& f, Tab& tab, AxisId axis, NumberField& field) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string& name = tab.catalog().axes[axis.index].name;
  const DisplayUnit& unit = tab.settings.units().length(axis);
  const double k = per_step(unit);
  draw_text_line(ui, at.x + ui.px(speeds_side), at.x + ui.px(56), at.y + ui.px(speeds_row / 2),
                 Face::body_bold, ui[Tone::ink], name);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(60), at.y + ui.px(2)));
  const Path per_second("{}/s", unit.name);
  NumberOptions o;
  o.range = {std::max(1.0, tab.catalog().jog_speed_min.value) * k, tab.catalog().jog_speed_max.value * k,
             unit.real ? unit.decimals : 0, per_second};
  o.width = 136, o.height = 28;
  o.sentence_below = false;
  if (!field.sentence.empty()) o.tip = field.sentence;
  const double speed = held_speed(tab, axis).value;
  const NumberEvent typed = number_field(ui, Path("jog/speed/{}", name), Path("Speed while held, {}", name),
                                         speed > 0 ? std::optional(speed * k) : std::nullopt, field, o);
  if (typed.committed) tab.settings.choose_jog_speed(axis, Pps(std::round(typed.value / k)));
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(204), at.y + ui.px(2)));
  ButtonOptions reset{.style = ButtonStyle::quiet, .width = 60, .height = 28};
  reset.tip = tab.settings.profile.jog_speed.value > 0 ? "As chosen for all axes." : "The controller's own.";
  reset.disabled =
      tab.settings.profile.axes[axis.index].jog_speed.value > 0 ? "" : "The axis has no speed of its own.";
  if (button(ui, Path("jog/speed/{}/reset", name), "Reset", reset).clicked) {
    tab.settings.choose_jog_speed(axis, Pps());
    field.reset();
  }
}

void JogSpeed::draw_field(Frame& f, float width, float height) {
  const DisplayUnit& unit = common_unit(f);
  const double k = per_step(unit);
  const std::string name = unit.name + "/s";
  NumberOptions o;
  o.range = {slowest(f) * k, fastest(f) * k, unit.real ? unit.decimals : 0, name};
  o.width = width;
  o.height = height;
  o.sentence_below = false;
  o.tip = "Enter takes it.";
  const NumberEvent e = number_field(f.ui, "jog/speed/field", "Speed while held", std::nullopt, field_, o);
  if (e.entered || e.committed) choose(f, e.value / k);
  if (e.field.entered && !e.entered) {  // the number is invalid, and the user must correct it
    type_into(f.ui, "jog/speed/field");
    was_typing_ = false;
    return;
  }
  if (e.entered || (was_typing_ && !e.field.typing)) typing_ = false;
  was_typing_ = e.field.typing;
}

void JogSpeed::draw_line(Frame& f, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_slider(f, width - speed_number_width);
  const float down = ui.px((slider_height - number_height) / 2);
  draw_number(f, ImVec2(at.x + ui.px(width - speed_number_width + 4), at.y + down), speed_number_width - 4,
              number_height);
}

void JogSpeed::draw(Frame& f, bool roomy) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  float y = at.y;
  if (roomy) {
    constexpr float number = 120;
    draw_text(ui, at, Face::body, ui[Tone::ink2],
              by_itself(f) ? "Speed, the controller's" : "Speed while held");
    draw_number(f, ImVec2(at.x + ui.px(f.area.width - number), at.y - ui.px(3)), number, number_height);
    y += ui.px(22);
    ImGui::SetCursorScreenPos(ImVec2(at.x, y));
    draw_slider(f, f.area.width);
  } else {
    constexpr float label = 76;
    draw_text_line(ui, at.x, at.x + ui.px(label), at.y + ui.px(slider_height / 2), Face::body, ui[Tone::ink2],
                   "Jog speed");
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(label), at.y));
    draw_line(f, f.area.width - label);
    y -= ui.px(4);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, y + ui.px(36)));
}

}  // namespace hw::panels
