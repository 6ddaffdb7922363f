#include "panels/control/action_form.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/device/travel_check.h"
#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float label_height = 18, control_height = 32;

/// The columns in which the fields of an action share the lines.
struct FieldGrid {
  int per_line = 1;
  float width = 0;
};
FieldGrid cells_of(std::size_t cells, float width, float least) {
  const int fit = std::max(1, static_cast<int>((width + between) / (least + between)));
  FieldGrid c;
  c.per_line = std::clamp(static_cast<int>(cells), 1, fit);
  c.width =
      std::floor((width - between * static_cast<float>(c.per_line - 1)) / static_cast<float>(c.per_line));
  return c;
}

/// A short button takes the place of a field; a long button has a line of its own.
bool fits_a_cell(std::string_view label) { return label.size() <= 14; }

bool is_axis(const ActionField& info) { return info.id == "axis"; }
bool is_switch(const ActionField& info) { return info.id == "on"; }

/// Whether a value has a field in the row. Values common to all rows, and values given by the row itself,
/// have none.
bool has_row_field(const ActionField& info) {
  return !is_axis(info) && !is_switch(info) && !info.for_all_rows;
}
float row_field_width(const ActionField& info) { return info.is_place ? 76.0f : 64.0f; }

NumberRange range_of(const ActionField& info, const ShownUnit& unit) {
  const double a = unit.shown(info.minimum), b = unit.shown(info.maximum);
  return {std::min(a, b), std::max(a, b), unit.decimals, unit.name};
}

std::string action_path(const Catalog& c, const ActionInfo& info, int axis) {
  return axis >= 0 && c.axes.size() > 1
             ? fmt::format("action/{}/{}", info.id, c.axes[static_cast<std::size_t>(axis)].name)
             : fmt::format("action/{}", info.id);
}

int rows_of_cells(std::size_t cells, int per_line) {
  return (static_cast<int>(cells) + per_line - 1) / per_line;
}

}  // namespace

ActionForm::ActionForm(const Catalog& catalog, int action, int axis, ActionForm& shared)
    : action_(action),
      info_(catalog.actions[static_cast<std::size_t>(action)]),
      path_(action_path(catalog, info_, axis)),
      row_axis_(axis),
      shared_(&shared),
      fields_(info_.fields.size()) {
  fill_in();
}

ActionForm::ActionForm(const Catalog& catalog, int action)
    : action_(action),
      info_(catalog.actions[static_cast<std::size_t>(action)]),
      path_(action_path(catalog, info_, -1)),
      fields_(info_.fields.size()) {
  fill_in();
}

void ActionForm::fill_in() {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const ActionField& info = info_.fields[i];
    for (const ParamChoice& choice : info.choices) {
      if (choice.value == info.fallback) fields_[i].chosen = static_cast<int>(fields_[i].names.size());
      fields_[i].names.push_back(choice.label);
      // Wide enough for the longest list value. The width is estimated, because there are no fonts yet to
      // measure it.
      least_ = std::max(least_, std::min(190.0f, 46 + 7.2f * static_cast<float>(choice.label.size())));
    }
    fields_[i].unit.decimals = fields_[i].unit.own_decimals = info.decimals;
    if (info.choices.empty()) put(i, info.fallback);
  }
}

std::string_view ActionForm::why_not(const Frame& f) const {
  if (!f.connected()) return "There is no link. It is available again when the controller answers.";
  if (info_.moves && !info_.while_busy) return f.tab.why_not_move();
  return {};
}

float ActionForm::height(float width) const {
  if (only_a_button()) return control_height + between;
  const bool in_cell = fits_a_cell(info_.label);
  const std::size_t cells = fields_.size() + (in_cell ? 1 : 0);
  const int lines = rows_of_cells(cells, cells_of(cells, width, least_).per_line);
  return static_cast<float>(lines) * (label_height + control_height + between) +
         (in_cell ? 0 : control_height + between);
}

float ActionForm::button_width(const Ui& ui) const {
  ButtonOptions o;
  o.moving = info_.moves;
  return gui::button_width(ui, info_.label, o);
}

void ActionForm::draw(Frame& f, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool in_cell = fits_a_cell(info_.label);
  const FieldGrid cells = cells_of(fields_.size() + (in_cell ? 1 : 0), width, least_);
  const auto place = [&](std::size_t n, float down) {
    const auto column = static_cast<float>(static_cast<int>(n) % cells.per_line);
    const auto line = static_cast<float>(static_cast<int>(n) / cells.per_line);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(column * (cells.width + between)),
                                     at.y + ui.px(line * (label_height + control_height + between) + down)));
  };
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    place(i, 0);
    draw_field(f, i, cells.width);
  }
  if (in_cell)
    place(fields_.size(), label_height);
  else
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(height(width) - control_height - between)));
  draw_button(f, in_cell ? cells.width : 0);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(height(width))));
  draw_refusal(f, width);
}

void ActionForm::draw_field(Frame& f, std::size_t i, float width) {
  Ui& ui = f.ui;
  const ActionField& info = info_.fields[i];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(width), at.y + ui.px(label_height / 2), Face::small, ui[Tone::ink2],
                 info.label);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(label_height)));
  draw_bare_field(f, i, width);
}

void ActionForm::draw_bare_field(Frame& f, std::size_t i, float width, float height) {
  Ui& ui = f.ui;
  const ActionField& info = info_.fields[i];
  Field& field = fields_[i];
  const Path id("{}/{}", path_, info.id);
  if (!field.names.empty()) {
    DropdownOptions o;
    o.width = width;
    o.height = height;
    const int picked = dropdown(ui, id, info.label, field.names, field.chosen, o);
    if (picked >= 0) field.chosen = picked;
    return;
  }
  follow_unit(f, i);
  NumberOptions o;
  o.range = range_of(info, field.unit);
  if (row_axis_ >= 0) o.range.unit = {};  // shown over the column
  o.width = width;
  o.height = height;
  o.tip = info.label;
  o.sentence_below = false;
  const NumberEvent e = number_field(ui, id, info.label, std::nullopt, field.number, o);
  if (e.field.edited) refused_.clear();
  if (e.entered && !info_.moves && why_not(f).empty()) send(f);
}

int ActionForm::axis_of(const ActionField& info) const {
  int axis = row_axis_ >= 0 ? row_axis_ : info.of_axis;
  for (std::size_t i = 0; axis < 0 && i < fields_.size(); ++i)
    if (info_.fields[i].id == "axis" && !fields_[i].names.empty())
      axis = static_cast<int>(info_.fields[i].choices[static_cast<std::size_t>(fields_[i].chosen)].value);
  return axis;
}

// Keeps the typed quantity when the axis or its unit changes.
void ActionForm::follow_unit(const Frame& f, std::size_t i) {
  Field& field = fields_[i];
  ShownUnit unit = shown_unit(f, info_.fields[i], axis_of(info_.fields[i]));
  if (unit == field.unit) return;
  const bool same_scale = unit.per == field.unit.per && unit.decimals == field.unit.decimals;
  const auto number = field.number.value();
  const ShownUnit before = std::exchange(field.unit, std::move(unit));
  if (number && !same_scale) field.number.set(field.unit.shown(before.value(*number)), field.unit.decimals);
}

void ActionForm::add_units(const Frame& f, UnitsOfRows& units) const {
  for (const ActionField& info : info_.fields)
    if (has_row_field(info)) units.add(shown_unit(f, info, axis_of(info)).name);
}

float ActionForm::row_fields_width(const ActionInfo& action) {
  float width = 0;
  for (const ActionField& info : action.fields)
    if (has_row_field(info)) width += row_field_width(info) + close_between;
  return width;
}

void ActionForm::draw_button(Frame& f, float width) {
  ButtonOptions o;
  o.moving = info_.moves;
  o.width = width;
  o.tip = info_.help;
  o.disabled = why_not(f);
  if (button(f.ui, Path("{}/go", path_), info_.label, o).clicked) send(f);
}

void ActionForm::draw_choice(Frame& f, std::string_view label, bool lamp, bool chosen) {
  ButtonOptions o;
  o.tip = info_.help;
  o.disabled = why_not(f);
  if (lamp) {
    const bool on = label == "on";
    o.icon = on ? Icon::disc : Icon::ring;
    o.icon_tone = on ? Tone::ok : Tone::ink3;
    o.on = on;
    o.width = 72;
  } else {
    o.style = ButtonStyle::segment;
    o.on = chosen;
  }
  if (button(f.ui, Path("{}/go", path_), label, o).clicked) send(f);
}

std::optional<std::int64_t> ActionForm::value(const ActionField& info, Field& field) {
  if (!field.names.empty()) return info.choices[static_cast<std::size_t>(field.chosen)].value;
  const NumberRange range = range_of(info, field.unit);
  field.number.sentence = range_sentence(field.number.text, range);
  if (!field.number.sentence.empty()) {
    if (refused_.empty())
      refused_ = fmt::format("{}: {}. Nothing was sent.", info.label,
                             field.number.sentence.ends_with('.')
                                 ? field.number.sentence.substr(0, field.number.sentence.size() - 1)
                                 : field.number.sentence);
    return {};
  }
  return field.unit.value(*field.number.value());
}

void ActionForm::send(Frame& f) {
  refused_.clear();
  past_.reset();
  std::vector<std::int64_t> values;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const ActionField& info = info_.fields[i];
    if (row_axis_ >= 0 && is_axis(info))
      values.push_back(row_axis_);
    else if (row_axis_ >= 0 && is_switch(info))
      values.push_back(switches_on_ ? 1 : 0);
    else if (const auto v = value(info, shared_ && info.for_all_rows ? shared_->fields_[i] : fields_[i]))
      values.push_back(*v);
  }
  if (values.size() != fields_.size()) return;
  asked_ = doubt_.send(f, intent::Act(action_, std::move(values)));
}

void ActionForm::draw_in_row(Frame& f, std::string_view verb, bool on, bool lamp, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  float x = at.x;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (!has_row_field(info_.fields[i])) continue;
    const float field = row_field_width(info_.fields[i]);
    ImGui::SetCursorScreenPos(ImVec2(x, at.y));
    draw_bare_field(f, i, field, row_height);
    x += f.ui.px(field + close_between);
  }
  ImGui::SetCursorScreenPos(ImVec2(x, at.y));
  ButtonOptions o;
  o.moving = info_.moves;
  o.height = row_height;
  o.width = width - (x - at.x) / f.ui.scale;
  o.tip = info_.help;
  o.disabled = why_not(f);
  if (lamp) {
    o.icon = on ? Icon::ring : Icon::disc;
    o.icon_tone = on ? Tone::ink3 : Tone::ok;
    o.on = !on;
  }
  if (button(f.ui, Path("{}/go", path_), verb, o).clicked) {
    switches_on_ = on;
    send(f);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + f.ui.px(row_height)));
  draw_refusal(f, width);
}

bool ActionForm::has_shared() const {
  return std::any_of(info_.fields.begin(), info_.fields.end(),
                     [](const ActionField& field) { return field.for_all_rows; });
}

void ActionForm::draw_shared(Frame& f, float label_width) {
  Ui& ui = f.ui;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (!info_.fields[i].for_all_rows) continue;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text_line(ui, at.x, at.x + ui.px(label_width), at.y + ui.px(control_height / 2), Face::body,
                   ui[Tone::ink2], info_.fields[i].label);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(label_width + between), at.y));
    draw_bare_field(f, i, 104);
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(control_height + between)));
  }
}

std::optional<std::int64_t> ActionForm::entered(std::size_t i) const {
  const ActionField& info = info_.fields[i];
  const auto number = fields_[i].number.value();
  if (!number) return {};
  const NumberRange range = range_of(info, fields_[i].unit);
  if (*number < range.min || *number > range.max) return {};
  return fields_[i].unit.value(*number);
}

void ActionForm::put(std::size_t i, std::int64_t value) {
  const ShownUnit& unit = fields_[i].unit;
  fields_[i].number.set(unit.shown(value), unit.decimals);
  refused_.clear();
}

void ActionForm::draw_refusal(Frame& f, float width) {
  if (const IntentOutcome* outcome = f.now.outcome_of(asked_);
      outcome && outcome->state != IntentState::pending) {
    asked_ = 0;
    if (outcome->state != IntentState::done && !doubt_.take_refusal(f, *outcome)) {
      refused_ = f.tab.messages.words_of(*outcome);
      past_ = outcome->past;
    }
  }
  if (f.now.forgotten(asked_)) asked_ = 0;
  if (refused_.empty() && !doubt_.open()) return;
  const ImVec2 after = ImGui::GetCursorScreenPos();
  const Rect form{ImVec2(after.x, after.y - f.ui.px(row_axis_ >= 0 ? row_height : height(width))),
                  ImVec2(after.x + f.ui.px(width), after.y - f.ui.px(between))};
  const Path prefix("{}", path_);
  if (doubt_.open()) {
    if (const IntentId sent = doubt_.draw(f, prefix, info_.label, form)) asked_ = sent;
  } else {
    draw_refusal_card(f, form);
  }
  ImGui::SetCursorScreenPos(after);
}

std::optional<std::size_t> ActionForm::field_past_limit() const {
  for (std::size_t i = 0; past_ && !info_.is_arc && i < fields_.size();
       ++i)  // the centre of an arc is not a target
    if (info_.fields[i].is_place && std::max(axis_of(info_.fields[i]), 0) == past_->axis.index) return i;
  return {};
}

/// Offers the nearest allowed position if a field names the position.
void ActionForm::draw_refusal_card(Frame& f, const Rect& form) {
  const Path id("{}/refused", path_), nearest("{}/nearest", path_);
  const auto field = field_past_limit();
  const Steps place = field ? nearest_allowed(f.now, *past_) : Steps();
  const Path label("Go to {}", field ? format_with_unit(place, f.tab.settings.unit(past_->axis)).view() : "");
  const std::array<Action, 1> actions = {
      Action{.id = nearest, .label = label, .disabled = why_not(f), .moving = true}};
  card_.begin(
      f, {.id = id, .about = info_.label, .words = refused_, .actions = {actions.data(), field ? 1u : 0u}},
      form);
  const RefusalTouch done = card_.end();
  if (done.closed) refused_.clear(), past_.reset();
  if (done.action != 0) return;
  put(*field, place.value);
  send(f);
}

}  // namespace hw::panels
