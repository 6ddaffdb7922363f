#include "panels/drawing/option_fields.h"

#include <utility>

#include "gui/widgets/area.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"

namespace hw::panels {

using namespace gui;

static constexpr float option_label_width = 116, option_row = 36;

void NumberOption::set(double value, int decimals) {
  field_.set(value, decimals);
  value_ = value;
}

bool NumberOption::draw(Frame& f, std::string_view id, std::string_view label, double least,
                        std::string_view unit) {
  const ImVec2 at = begin_option(f.ui, label);
  NumberOptions o;
  o.range = {least, 1e9, 6, unit};
  o.sentence_below = false;
  if (!field_.sentence.empty()) o.tip = field_.sentence;
  const NumberEvent event = number_field(f.ui, id, label, std::nullopt, field_, o);
  end_option(f.ui, at);
  if (!event.field.entered && !event.field.left) return false;
  const auto typed = field_.value();
  const bool emptied = field_.text.empty() && least <= 0;
  // What is no number leaves the one before: nothing is converted by a scale that nobody has meant.
  if (!emptied && !(typed && *typed >= least)) return false;
  value_ = emptied ? 0 : *typed;
  return true;
}

ImVec2 begin_option(Ui& ui, std::string_view label) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(option_label_width - 4), at.y + ui.px(16), Face::body, ui[Tone::ink2],
                 label);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(option_label_width), at.y));
  return at;
}

void end_option(Ui& ui, ImVec2 begun) {
  ImGui::SetCursorScreenPos(ImVec2(begun.x, begun.y + ui.px(option_row)));
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
