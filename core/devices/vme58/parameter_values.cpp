#include "core/devices/vme58/parameter_values.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/base/index.h"

namespace hw::vme58 {
namespace {

std::int64_t unit_of(int decimals) {
  std::int64_t unit = 1;
  for (int i = 0; i < decimals; ++i) unit *= 10;
  return unit;
}

std::int64_t in_units(double number, const ParameterFact& fact) {
  return std::llround(number * static_cast<double>(unit_of(fact.decimals)));
}

}  // namespace

std::optional<std::int64_t> ParameterValues::known(int axis, std::string_view letters) const {
  for (std::size_t i = 0; i < all_.size(); ++i)
    if (all_[i].axis == axis && all_[i].fact->letters == letters && snapshot_.params[i].known)
      return snapshot_.params[i].value;
  return std::nullopt;
}

bool ParameterValues::drives(int axis) const {
  for (std::size_t i = 0; i < all_.size(); ++i)
    if (all_[i].axis == axis && all_[i].fact->drives &&
        (!snapshot_.params[i].known || snapshot_.params[i].value != 0))
      return true;
  return false;
}

std::optional<motion::ServoGains> ParameterValues::gains(int axis) const {
  constexpr double hundredths = 100;
  constexpr std::array<std::pair<std::string_view, double motion::ServoGains::*>, 6> places{{
      {"KP", &motion::ServoGains::kp},
      {"KI", &motion::ServoGains::ki},
      {"KD", &motion::ServoGains::kd},
      {"KV", &motion::ServoGains::kv},
      {"KA", &motion::ServoGains::ka},
      {"KO", &motion::ServoGains::ko},
  }};
  motion::ServoGains gains;
  for (const auto& [letters, gain] : places) {
    const auto value = known(axis, letters);
    if (!value) return std::nullopt;
    gains.*gain = static_cast<double>(*value) / hundredths;
  }
  const auto interval = known(axis, "KN");
  if (gains.ki != 0 && !interval) return std::nullopt;
  if (interval) gains.kn = static_cast<int>(*interval);
  return gains;
}

void ParameterValues::know(std::size_t place, std::int64_t value) {
  snapshot_.params[place].value = value;
  snapshot_.params[place].known = true;
  note_fraction(*all_[place].fact, value);
}

void ParameterValues::note_fraction(const ParameterFact& fact, std::int64_t value) {
  if (!fact.shown || value % unit_of(fact.decimals) == 0) return;
  mark_due_ = mark_due_ || gains_are_whole_;
  gains_are_whole_ = false;
}

void ParameterValues::take(int axis) {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const Parameter& parameter = all_[i];
    if (parameter.axis != axis || !parameter.fact->shown) continue;
    const std::int64_t unit = unit_of(parameter.fact->decimals);
    const std::int64_t shown = readings_.value(axis, *parameter.fact->shown);
    ParamState& state = snapshot_.params[i];
    if (state.known && state.value / unit == shown) continue;
    state.value = shown * unit;
    state.known = unit == 1 || gains_are_whole_;
  }
}

void ParameterValues::note(const TextCommand& sent) {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const ParameterFact& fact = *all_[i].fact;
    if (all_[i].axis >= 0 && (sent.context.mode != where::single || all_[i].axis != sent.context.axis))
      continue;
    ParamState& state = snapshot_.params[i];
    const std::string_view letters = sent.fact->letters;
    if (!fact.on.empty() && fact.letters != "PA" && (letters == fact.on || letters == fact.off)) {
      state.value = letters == fact.on;
      state.known = true;
    } else if (fact.whole_board && fact.letters == "PN" && (letters == "PF" || letters == "CN")) {
      state.value = letters == "CN" ? ramp_cosine : ramp_linear;
      state.known = true;
    } else if (letters == fact.letters && !sent.numbers.empty() && sent.numbers.front() &&
               (!fact.shown || fact.decimals > 0)) {  // the data area shows only the whole part of a gain
      know(i, in_units(*sent.numbers.front(), fact));
    }
  }
}

void ParameterValues::as_from_factory() {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    snapshot_.params[i].value = catalog_.params[i].fallback;
    snapshot_.params[i].known = true;
  }
}

}  // namespace hw::vme58
