// Draws the cells of the tables with a row for each axis.
#include <algorithm>
#include <cmath>

#include "gui/model/axis_look.h"
#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/state_word.h"
#include "gui/widgets/text.h"
#include "panels/control/axis_tables.h"
#include "panels/measures.h"

namespace hw::panels {

using namespace gui;
namespace {

struct ActivityLook {
  Icon icon;
  std::string_view word;
  Tone tone;
};

std::string_view error_word(AxisError error) {
  switch (error) {
    case AxisError::limit_minus: return "hit \u2212 limit";
    case AxisError::limit_plus: return "hit + limit";
    case AxisError::limit: return "hit a limit";
    case AxisError::alarm: return "ended by alarm";
    case AxisError::stalled: return "stalled";
    case AxisError::too_far: return "too far off";
    case AxisError::not_corrected: return "not corrected";
    case AxisError::none: break;
  }
  return "error";
}

ActivityLook what_it_does(const Frame& f, int axis) {
  const AxisState& a = f.now.axes[static_cast<std::size_t>(axis)];
  const State state = state_of(f.now, axis, f.clock);
  if (a.activity == Activity::error && f.connected())
    return {Icon::diamond_solid, error_word(a.error), Tone::fault};
  if (a.alarm && f.connected()) return {Icon::diamond_solid, "alarm is on", Tone::fault};
  if (is_motion(state)) {
    std::string_view word = look_of(state).small;
    if (a.phase == Phase::accelerating) word = "ramping up";
    if (a.phase == Phase::constant) word = "steady";
    if (a.phase == Phase::decelerating) word = "slowing";
    return {look_of(state).icon, word, Tone::motion};
  }
  if (state == State::idle || state == State::in_place) return {Icon::ring, "at rest", Tone::ink2};
  return {look_of(state).icon, look_of(state).small, look_of(state).tone};
}

}  // namespace

void AxisTables::draw_cell(Frame& f, Column& column, std::size_t axis, const Rect& in) {
  using Shows = AxisColumn::Shows;
  Cell& cell = column.cells[axis];
  const auto index = static_cast<std::size_t>(std::max(0, cell.index));
  ImGui::SetCursorScreenPos(ImVec2(in.min.x, in.min.y + f.ui.px(2)));
  switch (column.info->shows) {
    case Shows::motion: return draw_motion(f, cell, axis, in);
    case Shows::readout: return draw_readout(f, index, in);
    case Shows::param: return draw_param(f, column, cell, in);
    case Shows::toggle: return cell.form ? draw_action(f, column, cell, in) : draw_toggle(f, cell, in);
    case Shows::action: return draw_action(f, column, cell, in);
  }
}

void AxisTables::draw_motion(Frame& f, Cell& cell, std::size_t i, const Rect& in) {
  Ui& ui = f.ui;
  const AxisId axis{static_cast<std::uint8_t>(i)};
  const ActivityLook does = what_it_does(f, static_cast<int>(i));
  const bool held = cell.form && f.now.axes[i].activity == Activity::error && f.connected();
  const float middle = std::floor(in.centre().y);
  const float clear_left = in.max.x - ui.px(60);
  draw_icon(ImGui::GetWindowDrawList(), does.icon, ImVec2(in.min.x + ui.px(6), middle), ui.px(12),
            ui[does.tone]);
  const float words_end = held ? clear_left - ui.px(close_between) : in.max.x - ui.px(speed_width);
  const Face face = does.tone == Tone::ink2 ? Face::body : Face::body_bold;
  draw_text_line(ui, in.min.x + ui.px(20), words_end, middle, face, ui[does.tone], does.word);
  show(ui, {Path("control/{}/does", f.catalog.axes[i].name), Kind::text, "Motion", does.word, {}, false, {}},
       {in.min, ImVec2(words_end, in.max.y)});
  if (held) {
    ImGui::SetCursorScreenPos(ImVec2(clear_left, in.min.y + ui.px(2)));
    return cell.form->draw_in_row(f, "Clear", true, false, 60);
  }
  const DisplayUnit& unit = f.tab.settings.unit(axis);
  const NumberText speed =
      format_number(f.now.axes[i].speed.value * (unit.real ? std::abs(unit.per_step) : 1), unit.decimals);
  const bool moves = f.now.axis_moves(static_cast<int>(i)) && !only_goes_along(f.now.axes[i]);
  const Face number = moves ? Face::body_bold : Face::body;
  const float wide = std::ceil(text_width(ui, number, speed));
  draw_text_line(ui, std::max(words_end, in.max.x - wide), in.max.x + 1, middle, number,
                 ui[moves ? Tone::ink : Tone::ink3], speed);
}

std::optional<bool> AxisTables::is_on(const Frame& f, const Cell& cell) {
  if (cell.state < 0) return {};
  const auto i = static_cast<std::size_t>(cell.state);
  if (!cell.state_is_param)
    return f.now.readouts_known[i] ? std::optional<bool>(f.now.readouts[i] != 0) : std::nullopt;
  const ParamState& p = f.now.params[i];
  return p.known ? std::optional<bool>((p.value & cell.state_bits) != 0) : std::nullopt;
}

void AxisTables::draw_action(Frame& f, const Column& column, Cell& cell, const Rect& in) {
  const ActionInfo& action = f.catalog.actions[static_cast<std::size_t>(cell.index)];
  const bool lamp = column.info->shows == AxisColumn::Shows::toggle;
  if (lamp && cell.state >= 0 && !cell.state_is_param && ImGui::IsRectVisible(in.min, in.max))
    f.tab.watched.look_at_group(f.catalog.readouts[static_cast<std::size_t>(cell.state)].group);
  const std::optional<bool> on = is_on(f, cell);
  std::string_view verb =
      column.info->verb_on.empty() ? std::string_view(action.label) : column.info->verb_on;
  if (on.value_or(false) && !column.info->verb_off.empty()) verb = column.info->verb_off;
  if (lamp) verb = !on ? "?" : *on ? "on" : "off";
  cell.form->draw_in_row(f, verb, !on.value_or(false), lamp, (in.max.x - in.min.x) / f.ui.scale);
}

void AxisTables::draw_toggle(Frame& f, const Cell& cell, const Rect& in) {
  const auto i = static_cast<std::size_t>(cell.index);
  const ParamInfo& p = f.catalog.params[i];
  const ParamState& has = f.now.params[i];
  const bool on = has.known && has.value != 0;
  ButtonOptions o;
  o.height = ActionForm::row_height;
  o.width = (in.max.x - in.min.x) / f.ui.scale;
  o.icon = on ? Icon::disc : Icon::ring;
  o.icon_tone = on ? Tone::ok : Tone::ink3;
  o.on = on;
  o.tip = p.explanation;
  o.disabled = !f.connected() ? "There is no link." : has.known ? "" : "It has not been read yet.";
  if (button(f.ui, Path("control/{}", p.mnemonic), !has.known ? "?" : on ? "on" : "off", o).clicked)
    f.send(intent::SetParam(p.mnemonic, on ? 0 : 1));
}

void AxisTables::draw_param(Frame& f, Column& column, Cell& cell, const Rect& in) {
  const auto i = static_cast<std::size_t>(cell.index);
  const ParamInfo& p = f.catalog.params[i];
  const ParamState& has = f.now.params[i];
  const Path id("control/{}", p.mnemonic);
  if (const AxisColumn& info = *column.info; cell.state >= 0 && !info.otherwise.empty()) {
    const ParamState& rules = f.now.params[static_cast<std::size_t>(cell.state)];
    if (rules.known && rules.value != info.state_for) {
      draw_text_line(f.ui, in.min.x, in.max.x + f.ui.px(between), std::floor(in.centre().y), Face::body,
                     f.ui[Tone::ink3], info.otherwise);
      return show(f.ui, {id, Kind::text, p.label, info.otherwise, {}, false, p.explanation}, in);
    }
  }
  const float width = (in.max.x - in.min.x) / f.ui.scale;
  if (!p.choices.empty()) {
    int chosen = -1;
    for (std::size_t n = 0; n < p.choices.size(); ++n)
      if (has.known && p.choices[n].value == has.value) chosen = static_cast<int>(n);
    DropdownOptions o;
    o.disabled = f.no_link();
    o.tip = p.explanation;
    o.width = width;
    o.height = ActionForm::row_height;
    o.none = "?";
    const int picked = dropdown(f.ui, id, p.label, column.choices, chosen, o);
    if (picked >= 0) f.send(intent::SetParam(p.mnemonic, p.choices[static_cast<std::size_t>(picked)].value));
    return;
  }
  const ShownUnit unit = shown_unit(f, p);
  if (unit != cell.unit) cell.number.reset(), cell.unit = unit;  // the number was typed in another unit
  NumberOptions o;
  const double a = unit.shown(p.minimum), b = unit.shown(p.maximum);
  o.range = {std::min(a, b), std::max(a, b), unit.decimals, {}};
  o.disabled = f.no_link();
  o.tip = p.explanation;
  o.width = width;
  o.height = ActionForm::row_height;
  o.sentence_below = false;
  const NumberEvent e =
      number_field(f.ui, id, p.label, has.known ? std::optional<double>(unit.shown(has.value)) : std::nullopt,
                   cell.number, o);
  if (e.committed) f.send(intent::SetParam(p.mnemonic, unit.value(e.value)));
}

}  // namespace hw::panels
