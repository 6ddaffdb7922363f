#include "panels/drawing/scale_option.h"

#include <cmath>

#include "core/base/lengths.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr double least = 1e-9;

bool is_in_inches(ScaleForm form) {
  return form == ScaleForm::steps_in_inch || form == ScaleForm::inches_per_step;
}

bool is_length(ScaleForm form) {
  return form == ScaleForm::mm_per_step || form == ScaleForm::inches_per_step;
}

double shown_of(double steps_in_mm, ScaleForm form) {
  const double steps = is_in_inches(form) ? steps_in_mm * mm_per_inch : steps_in_mm;
  return is_length(form) && steps > 0 ? 1 / steps : steps;
}

double steps_in_mm_of(double shown, ScaleForm form) {
  const double steps = is_length(form) && shown > 0 ? 1 / shown : shown;
  return is_in_inches(form) ? steps / mm_per_inch : steps;
}

/// The fewest decimals that show the value to five significant digits.
int decimals_for(double value) {
  constexpr int most = 12;
  int decimals = 3;
  for (double unit = 1e-3; decimals < most; ++decimals, unit /= 10)
    if (std::abs(std::round(value / unit) * unit - value) <= value * 1e-5) break;
  return decimals;
}

}  // namespace

Path words_of(ScaleForm form, std::string_view step_word) {
  const std::string_view length = is_in_inches(form) ? "in" : "mm";
  if (!is_length(form)) return Path("{}/{}", step_word, length);
  if (step_word.ends_with('s')) step_word.remove_suffix(1);
  return Path("{}/{}", length, step_word);
}

void ScaleOption::set(double steps_in_mm, ScaleForm form) {
  steps_in_mm_ = steps_in_mm, form_ = form;
  const double shown = shown_of(steps_in_mm, form);
  field_.set(shown, is_length(form) ? decimals_for(shown) : 3);
}

bool ScaleOption::draw(Frame& f, std::string_view id, std::string_view axis) {
  const std::string_view unit = f.catalog.step_word;
  const bool changed = field_.draw(f, id, Path("{}, {}", words_of(form_, unit).view(), axis),
                                   is_length(form_) ? least : 1e-6, {}, is_length(form_) ? 12 : 6);
  if (changed) steps_in_mm_ = steps_in_mm_of(field_.value(), form_);
  return changed;
}

}  // namespace hw::panels
