#include "panels/control/action_form.h"

#include <algorithm>
#include <cmath>

#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float label_height = 18, control_height = 32;

/// How the fields of an action share the lines.
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

/// A short button takes the place of one more field, a long one a line of its own.
bool fits_a_cell(std::string_view label) { return label.size() <= 14; }

int lines_of(std::size_t cells, int per_line) { return (static_cast<int>(cells) + per_line - 1) / per_line; }

}  // namespace

ActionForm::ActionForm(const Catalog& catalog, int action)
    : action_(action),
      info_(catalog.actions[static_cast<std::size_t>(action)]),
      fields_(info_.fields.size()) {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const ActionField& info = info_.fields[i];
    for (const ParamChoice& choice : info.choices) {
      if (choice.value == info.fallback) fields_[i].chosen = static_cast<int>(fields_[i].names.size());
      fields_[i].names.push_back(choice.label);
      // Wide enough for the longest value of a list; figured before there are fonts to measure with.
      least_ = std::max(least_, std::min(190.0f, 46 + 7.2f * static_cast<float>(choice.label.size())));
    }
    if (info.choices.empty())
      fields_[i].number.set(static_cast<double>(info.fallback) / std::pow(10.0, info.decimals),
                            info.decimals);
  }
}

std::string_view ActionForm::why_not(const Frame& f) const {
  if (!f.connected()) return "There is no link. It comes back when the controller answers.";
  if (info_.moves && !info_.while_busy) return f.tab.why_not_move();
  return {};
}

float ActionForm::height(float width) const {
  if (only_a_button()) return control_height + between;
  const bool in_cell = fits_a_cell(info_.label);
  const std::size_t cells = fields_.size() + (in_cell ? 1 : 0);
  const int lines = lines_of(cells, cells_of(cells, width, least_).per_line);
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
  Field& field = fields_[i];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(width), at.y + ui.px(label_height / 2), Face::small, ui[Tone::ink2],
                 info.label);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(label_height)));
  const Path id("action/{}/{}", info_.id, info.id);
  if (!field.names.empty()) {
    DropdownOptions o;
    o.width = width;
    const int picked = dropdown(ui, id, info.label, field.names, field.chosen, o);
    if (picked >= 0) field.chosen = picked;
    return;
  }
  const double scale = std::pow(10.0, info.decimals);
  NumberOptions o;
  o.range.min = static_cast<double>(info.minimum) / scale;
  o.range.max = static_cast<double>(info.maximum) / scale;
  o.range.decimals = info.decimals;
  const std::string unit = unit_of(f, info);
  o.range.unit = unit;
  o.width = width;
  o.sentence_below = false;
  const NumberEvent e = number_field(ui, id, info.label, std::nullopt, field.number, o);
  if (e.field.edited) refused_.clear();
  if (e.entered && !info_.moves && why_not(f).empty()) send(f);
}

// In counts or in pulses: that depends on the axis that the form has chosen.
std::string ActionForm::unit_of(const Frame& f, const ActionField& info) const {
  if (!info.follows_loop) return info.unit;
  int axis = info.of_axis;
  for (std::size_t i = 0; axis < 0 && i < fields_.size(); ++i)
    if (info_.fields[i].id == "axis" && !fields_[i].names.empty())
      axis = static_cast<int>(info_.fields[i].choices[static_cast<std::size_t>(fields_[i].chosen)].value);
  return counted_unit(f.catalog, f.now, info.unit, axis);
}

void ActionForm::draw_button(Frame& f, float width) {
  ButtonOptions o;
  o.moving = info_.moves;
  o.width = width;
  o.tip = info_.help;
  o.disabled = why_not(f);
  if (button(f.ui, Path("action/{}/go", info_.id), info_.label, o).clicked) send(f);
}

std::optional<std::int64_t> ActionForm::value(const Frame& f, const ActionField& info, Field& field) {
  if (!field.names.empty()) return info.choices[static_cast<std::size_t>(field.chosen)].value;
  const double scale = std::pow(10.0, info.decimals);
  const std::string unit = unit_of(f, info);
  const NumberRange range{static_cast<double>(info.minimum) / scale,
                          static_cast<double>(info.maximum) / scale, info.decimals, unit};
  field.number.sentence = range_sentence(field.number.text, range);
  if (!field.number.sentence.empty()) {
    if (refused_.empty())
      refused_ = fmt::format("{}: {}. Nothing was sent.", info.label,
                             field.number.sentence.ends_with('.')
                                 ? field.number.sentence.substr(0, field.number.sentence.size() - 1)
                                 : field.number.sentence);
    return {};
  }
  return std::llround(*field.number.value() * scale);
}

void ActionForm::send(Frame& f) {
  refused_.clear();
  std::vector<std::int64_t> values;
  for (std::size_t i = 0; i < fields_.size(); ++i)
    if (const auto v = value(f, info_.fields[i], fields_[i])) values.push_back(*v);
  if (values.size() != fields_.size()) return;
  asked_ = doubt_.send(f, intent::Act(action_, std::move(values)));
}

void ActionForm::draw_refusal(Frame& f, float width) {
  if (const IntentFate* fate = f.now.fate_of(asked_); fate && fate->fate != Fate::pending) {
    asked_ = 0;
    if (fate->fate != Fate::done && !doubt_.hear(f, *fate)) refused_ = fate->sentence.view();
  }
  if (f.now.forgotten(asked_)) asked_ = 0;
  if (refused_.empty() && !doubt_.open()) return;
  const ImVec2 after = ImGui::GetCursorScreenPos();
  const Rect form{ImVec2(after.x, after.y - f.ui.px(height(width))),
                  ImVec2(after.x + f.ui.px(width), after.y - f.ui.px(between))};
  const Path prefix("action/{}", info_.id), id("action/{}/refused", info_.id);
  if (doubt_.open()) {
    if (const IntentId sent = doubt_.draw(f, prefix, info_.label, form)) asked_ = sent;
  } else {
    card_.begin(f, {.id = id, .about = info_.label, .words = refused_, .actions = {}}, form);
    if (card_.end().closed) refused_.clear();
  }
  ImGui::SetCursorScreenPos(after);
}

}  // namespace hw::panels
