#include "panels/position/axis_line.h"

#include <cmath>

#include "gui/widgets/digits.h"
#include "gui/widgets/row.h"
#include "gui/widgets/state_word.h"
#include "gui/widgets/text.h"
#include "panels/jog/jog_button.h"
#include "panels/measures.h"
#include "panels/position/position_words.h"
#include "panels/position/travel_bar.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float jog_width = 32, state_middle = 34;

float jogs_px(const Ui& ui) { return ui.px(2 * jog_width + close_between); }

void draw_jogs(Ui& ui, Tab& tab, AxisId axis, const Rect& r) {
  HoldOptions o;
  o.width = o.height = jog_width;
  for (const Sign sign : {Sign::minus, Sign::plus}) {
    const float x = r.max.x - jogs_px(ui) + (sign == Sign::plus ? ui.px(jog_width + close_between) : 0);
    ImGui::SetCursorScreenPos(ImVec2(x, r.min.y + ui.px((axis_line_height - jog_width) / 2)));
    o.icon = sign == Sign::minus ? Icon::back : Icon::play;
    draw_jog_button(ui, tab, axis, sign, "", o);
  }
}

/// Draws the user's name and the position.
Touch draw_number(Ui& ui, Tab& tab, AxisId axis, const AxisLine& line, float left, float right, float top) {
  const DisplayUnit& unit = tab.settings.unit(axis);
  const NumberText number = shown_position(tab.now().axes[axis.index], unit);
  const std::string_view unit_name = unit.real ? std::string_view(unit.name) : std::string_view();
  DigitsOptions d;
  d.face = line.face;
  d.state = digits_state(tab.now(), axis.index, tab.clock());
  d.width = (right - left) / ui.scale;
  d.tip = line.tip;
  const float number_left = right - digits_width(ui, d.face, number, unit_name);
  const float label_end = number_left - ui.px(6);
  if (label_end - left > ui.px(24))
    draw_text_line(ui, left, label_end, top + ui.px(16), Face::small, ui[Tone::ink2], line.label);
  const float drop = std::floor((ui.line(Face::digits26) - ui.line(line.face)) / 2);
  ImGui::SetCursorScreenPos(ImVec2(left, top + drop));
  return digits(ui, Path("dro/{}/position", line.name), Path("Position of {}", line.name), number, unit_name,
                d);
}

/// Draws the state below the number, so that a long number does not run into it. Returns its right end.
float draw_state(Ui& ui, const AxisLine& line, float left, float right, const Rect& row) {
  const float middle = row.min.y + ui.px(state_middle);
  const StateLook& state = look_of(line.state);
  draw_icon(ImGui::GetWindowDrawList(), state.icon, ImVec2(left + ui.px(6), middle), ui.px(10),
            ui[state.tone]);
  draw_text_line(ui, left + ui.px(18), right, middle, Face::small_bold, ui[state.tone], state.word);
  const float end = left + ui.px(18) + std::ceil(text_width(ui, Face::small_bold, state.word));
  show(ui, {Path("dro/{}/state", line.name), Kind::text, "State", state.word, {}, false, {}},
       {ImVec2(left, row.min.y + ui.line(Face::digits26)), ImVec2(std::min(end, right), row.max.y)});
  return std::min(end, right);
}

}  // namespace

Face axis_line_face(const Ui& ui, float number_px, float width) {
  constexpr float name = 24;
  return number_px + ui.px(name) <= ui.px(width) - jogs_px(ui) - ui.px(8) ? Face::digits26 : Face::stop;
}

AxisLineTouch draw_axis_line(Ui& ui, Tab& tab, AxisId axis, const AxisLine& line, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  RowOptions o;
  o.height = axis_line_height;
  o.chosen = line.chosen;
  o.bad = look_of(line.state).tone == Tone::fault;
  o.value = look_of(line.state).small;
  const Touch t = row(ui, line.id, line.name, o);
  const Rect r{at, ImVec2(at.x + ui.px(width), t.rect.max.y)};
  draw_text_line(ui, r.min.x, r.max.x, r.min.y + ui.px(16), Face::title_bold, ui[Tone::ink], line.name);
  const float name = std::max(ui.px(20), std::ceil(text_width(ui, Face::title_bold, line.name)) + ui.px(8));
  const float right = r.max.x - jogs_px(ui) - ui.px(8), middle = r.min.y + ui.px(state_middle);
  const float state_end = draw_state(ui, line, r.min.x, right, r);
  draw_jogs(ui, tab, axis, r);
  AxisLineTouch touched;
  touched.pressed = t.clicked;
  touched.number = draw_number(ui, tab, axis, line, r.min.x + name, right, r.min.y);
  touched.aside = {ImVec2(state_end + ui.px(8), middle - ui.px(8)), ImVec2(right, middle + ui.px(8))};
  draw_travel_line(ui, tab, axis, ImVec2(r.min.x, r.max.y - ui.px(2)), right - r.min.x);
  ImGui::SetCursorScreenPos(ImVec2(at.x, t.rect.max.y));
  return touched;
}

}  // namespace hw::panels
