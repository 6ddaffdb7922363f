#include "gui/widgets/number_field.h"

#include <charconv>
#include <cmath>

#include "gui/widgets/digits.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

std::string as_text(double value, int decimals) {
  char buffer[64];
  return std::string(format_number(buffer, value, decimals));
}

/// A range as a person writes it: "0.5" and not "0.500".
std::string short_number(double value, int decimals) {
  std::string s = as_text(value, decimals);
  if (s.find('.') == std::string::npos) return s;
  while (s.back() == '0') s.pop_back();
  if (s.back() == '.') s.pop_back();
  return s;
}

int decimals_typed(std::string_view text) {
  const std::size_t point = text.find_first_of(".,");
  if (point == std::string_view::npos) return 0;
  int n = 0;
  for (char c : text.substr(point + 1)) n += c >= '0' && c <= '9';
  return n;
}

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

std::optional<double> read_number(std::string_view text) {
  char plain[64] = {};
  std::size_t n = 0;
  bool point = false;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    if (n + 1 >= sizeof plain) return {};
    if (rest.starts_with("\xE2\x88\x92")) {  // the real minus
      plain[n++] = '-';
      i += 3;
    } else if (rest.starts_with("\xE2\x80\x89")) {  // thin space between groups
      i += 3;
    } else if (rest[0] == ',' || rest[0] == '.') {
      if (point) return {};
      point = true;
      plain[n++] = '.';
      ++i;
    } else if (rest[0] == ' ' || (rest[0] == '+' && n == 0)) {
      ++i;
    } else {
      plain[n++] = rest[0];
      ++i;
    }
  }
  double value = 0;
  const auto [end, error] = std::from_chars(plain, plain + n, value, std::chars_format::fixed);
  if (n == 0 || error != std::errc() || end != plain + n || !std::isfinite(value)) return {};
  return value;
}

std::string range_sentence(std::string_view text, const NumberRange& range) {
  const std::optional<double> value = read_number(text);
  std::string unit;
  if (!range.unit.empty()) unit.append(" ").append(range.unit);
  if (!value) return text.empty() ? "A number is missing." : "This is not a number.";
  if (*value < range.min || *value > range.max) {
    if (range.min <= -1e12) return "At most " + short_number(range.max, range.decimals) + unit + ".";
    if (range.max >= 1e12) return "At least " + short_number(range.min, range.decimals) + unit + ".";
    return short_number(range.min, range.decimals) + " to " + short_number(range.max, range.decimals) + unit +
           " only";
  }
  if (decimals_typed(text) > range.decimals) {
    const double scale = std::pow(10.0, range.decimals);
    if (std::fabs(*value * scale - std::round(*value * scale)) > 1e-6)
      return range.decimals == 0 ? "Whole numbers only"
                                 : "At most " + std::to_string(range.decimals) + " decimals";
  }
  return {};
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
  ImGui::BeginGroup();  // the sentence stands under the field, wherever that was placed
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
