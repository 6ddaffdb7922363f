#include "panels/jog/jog_speed.h"

#include <algorithm>
#include <cmath>

#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/jog/jog_units.h"
#include "panels/position/position_words.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float slider_height = 32, number_height = 26, speed_number_width = 112;  // whatever its text

/// The speed of the axes without a requested speed.
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
NumberText own_speed_words(const OwnSpeed& own, const DisplayUnit& unit) {
  if (own.speed.value > 0 && own.alike) return format_speed(own.speed, unit);
  NumberText words;
  words.append(own.alike ? "not known yet" : "each its own");
  return words;
}

bool by_itself(const Frame& f) { return f.tab.jog_speed().value <= 0; }

NumberText speed_in_words(const Frame& f) {
  const DisplayUnit unit = common_unit(f);
  return by_itself(f) ? own_speed_words(own_speed(f), unit) : format_speed(f.tab.jog_speed(), unit);
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
  const double wished = std::clamp(std::round(speed), slowest(f), fastest(f));
  f.tab.choose_jog(f.tab.jog_step(), Pps(wished == std::round(usual(f)) ? 0 : wished));
}

double per_step(const DisplayUnit& unit) { return unit.real ? unit.per_step : 1; }

}  // namespace

namespace {

/// Right-aligned; in less room without the unit, which the positions show too.
void draw_number_words(const Frame& f, const Rect& r, std::string_view words) {
  const Ui& ui = f.ui;
  const auto fits = [&](std::string_view s) { return text_width(ui, Face::body_bold, s) <= r.width(); };
  NumberText brief;
  if (!fits(words) && !by_itself(f)) brief = format_brief_speed(f.tab.jog_speed(), common_unit(f));
  if (!fits(words) && by_itself(f) && own_speed(f).speed.value > 0 && own_speed(f).alike)
    brief = format_brief_speed(own_speed(f).speed, common_unit(f));
  const std::string_view said = brief.view().empty() ? words : brief.view();
  const float width = std::min(r.width(), std::ceil(text_width(ui, Face::body_bold, said)));
  draw_text_line(ui, r.max.x - width, r.max.x + 1, r.centre().y, Face::body_bold, ui[Tone::ink], said);
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
  o.tip = !by_itself(f) ? "Speed while held. A double click goes back to the controller's own."
          : own_speed(f).alike
              ? "Speed while held: the controller's own. Drag to choose another."
              : "Speed while held: each axis has one of its own. Drag to choose one for all.";
  o.value_text = words;
  o.width = width;
  double speed = by_itself(f) ? o.normal : f.tab.jog_speed().value;
  if (slider(f.ui, "jog/speed", "Speed while held", speed, o)) choose(f, speed);
}

void JogSpeed::begin_typing(Frame& f) {
  const DisplayUnit unit = common_unit(f);
  const double speed = by_itself(f) ? usual(f) : f.tab.jog_speed().value;
  field_.set(speed * per_step(unit), unit.real ? unit.decimals : 0);
  typing_ = true;
  was_typing_ = false;
  type_into(f.ui, "jog/speed/field");
}

/// The number at the right end of its place; a click turns it into a field.
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
                         "Speed while held. Click to type another."},
                        ImVec2(ui.px(width), ui.px(height)));
  const float around = ui.px(4);
  if (t.hovered || t.held)
    draw_fill(ui, {t.rect.min, ImVec2(t.rect.max.x + around, t.rect.max.y)}, ui[Tone::hover]);
  draw_number_words(f, t.rect, words);
  draw_ring(ui, t);
  if (t.clicked) begin_typing(f);
}

void JogSpeed::draw_field(Frame& f, float width, float height) {
  const DisplayUnit unit = common_unit(f);
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
  if (e.field.entered && !e.entered) {  // invalid: to be corrected in the field
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
