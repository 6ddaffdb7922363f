#include "gui/widgets/number_field.h"

#include <cmath>

#include "gui/model/units_format.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

std::string as_text(double value, int decimals) { return std::string(format_number(value, decimals).view()); }

}  // namespace

struct NumberAccess {
  static void follow(NumberField& f, std::optional<double> shown, int decimals) {
    if (f.dirty_ || !shown) return;
    if (f.has_shown_ && f.shown_ == *shown && !f.text.empty()) return;
    f.text = as_text(*shown, decimals);
    f.shown_ = *shown;
    f.has_shown_ = true;
    f.sentence.clear();
  }
  static void edited(NumberField& f) {
    f.dirty_ = true;
    f.sentence.clear();
  }
  static void settle(NumberField& f, bool follows) {
    f.dirty_ = !follows;
    f.has_shown_ = false;
  }
};

std::optional<double> NumberField::value() const { return read_number(text); }

void NumberField::set(double value, int decimals) {
  text = as_text(value, decimals);
  dirty_ = true;
  sentence.clear();
}

void NumberField::reset() {
  text.clear();
  sentence.clear();
  dirty_ = has_shown_ = false;
}

NumberEvent number_field(Ui& ui, std::string_view id, std::string_view label, std::optional<double> shown,
                         NumberField& state, const NumberOptions& o) {
  NumberEvent event;
  NumberAccess::follow(state, shown, o.range.decimals);
  FieldOptions field;
  field.disabled = o.disabled;
  field.tip = o.tip;
  field.unit = o.range.unit;
  field.width = o.width;
  field.height = o.height;
  field.right = field.whole = true;
  field.error = !state.sentence.empty() || !o.refused.empty();
  field.changed = o.changed || (shown && state.dirty());
  field.stale = o.stale;
  ImGui::BeginGroup();  // keeps the sentence below the field
  event.field = text_field(ui, id, label, state.text, field);
  if (event.field.edited) NumberAccess::edited(state);
  const bool done = event.field.entered || (event.field.left && state.dirty());
  if (done) {
    state.sentence = range_sentence(state.text, o.range);
    if (state.sentence.empty()) {
      event.value = *state.value();
      event.entered = event.field.entered;
      event.committed = !shown || state.dirty();
      if (state.dirty()) NumberAccess::settle(state, shown.has_value());
    }
  }
  const std::string_view below = !state.sentence.empty() ? std::string_view(state.sentence) : o.refused;
  if (o.sentence_below && !below.empty()) wrapped(ui, Face::small, Tone::fault, below, o.width);
  ImGui::EndGroup();
  return event;
}

}  // namespace hw::gui
