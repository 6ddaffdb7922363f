#include "panels/drawing/option_fields.h"

#include <cctype>
#include <utility>

#include "gui/widgets/area.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"

namespace hw::panels {

using namespace gui;

static constexpr float option_label_width = 116, field_row = 36;

/// "Tolerance: this is not a number."
static std::string wrong_number(std::string_view label, const std::string& text, const NumberRange& range) {
  std::string why = range_sentence(text, range);
  if (why.empty()) why = "this number is not possible";
  why.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(why.front())));
  if (!why.ends_with('.')) why += '.';
  return std::string(label) + ": " + why;
}

void NumberOption::set(double value, int decimals) {
  field_.set(value, decimals);
  value_ = value;
  shown_ = field_.text;
  wrong_.clear();
}

std::string first_wrong(std::initializer_list<const NumberOption*> options) {
  for (const NumberOption* option : options)
    if (!option->wrong().empty()) return option->wrong();
  return {};
}

bool NumberOption::draw(Frame& f, std::string_view id, std::string_view label, double least,
                        std::string_view unit, int decimals) {
  const ImVec2 at = begin_option(f.ui, label, wrong_.empty() ? Tone::ink2 : Tone::fault);
  NumberOptions o;
  o.tip = wrong_;  // below the field the sentence would move the control being clicked
  o.range = {least, 1e9, decimals, unit};
  o.sentence_below = false;
  const NumberEvent event = number_field(f.ui, id, label, std::nullopt, field_, o);
  end_option(f.ui, at);
  if (!event.field.entered && !event.field.left) return false;
  if (field_.text == shown_) {  // not edited; the value is more exact than its text
    if (shown_.empty()) field_.reset();
    return !std::exchange(wrong_, {}).empty();
  }
  const auto typed = field_.value();
  const bool emptied = field_.text.empty() && least <= 0;
  // Invalid input keeps the previous value, so that no drawing is converted with an unintended scale.
  if (emptied || (typed && *typed >= least && *typed <= o.range.max)) {
    wrong_.clear();
    value_ = emptied ? 0 : *typed;
    if (emptied) field_.reset();  // an empty field is allowed, and not marked red
    shown_ = field_.text;
  } else {
    wrong_ = wrong_number(label, field_.text, o.range);
  }
  return true;
}

ImVec2 begin_option(Ui& ui, std::string_view label, Tone tone) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(option_label_width - 4), at.y + ui.px(16), Face::body, ui[tone],
                 label);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(option_label_width), at.y));
  return at;
}

void end_option(Ui& ui, ImVec2 begun) {
  ImGui::SetCursorScreenPos(ImVec2(begun.x, begun.y + ui.px(field_row)));
}

bool toggle_option(Frame& f, std::string_view id, std::string_view label, bool& value) {
  ToggleOptions o;
  o.state = value ? ToggleState::on : ToggleState::off;
  const bool clicked = toggle_lamp(f.ui, id, label, o).clicked;
  if (clicked) value = !value;
  gap(f.ui, 4);
  return clicked;
}

}  // namespace hw::panels
