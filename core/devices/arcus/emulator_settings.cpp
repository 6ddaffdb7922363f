#include "core/devices/arcus/emulator_settings.h"

#include <algorithm>

namespace hw::arcus {
namespace {

bool digits_only(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// "0.8", ".8", "1": the number times a thousand, cut after the third decimal.
std::optional<std::int64_t> parse_thousandths(std::string_view text) {
  const auto point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  std::string decimals(point == std::string_view::npos ? "" : text.substr(point + 1));
  if (whole.size() > 9 || decimals.size() > 9 || whole.size() + decimals.size() == 0) return std::nullopt;
  if ((!whole.empty() && !digits_only(whole)) || (!decimals.empty() && !digits_only(decimals)))
    return std::nullopt;
  decimals.resize(3, '0');
  return parse_integer(std::string(whole) + decimals);
}

}  // namespace

std::optional<std::int64_t> parse_integer(std::string_view text) {
  const bool negative = !text.empty() && text.front() == '-';
  if (!text.empty() && (negative || text.front() == '+')) text.remove_prefix(1);
  if (!digits_only(text) || text.size() > 18) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : text) value = value * 10 + (c - '0');
  return negative ? -value : value;
}

Settings::Settings(const Model& model) : model_(&model) {
  for (const SettingFact& f : model.settings) {
    facts_[static_cast<std::size_t>(f.id)] = &f;
    places_[static_cast<std::size_t>(f.id)] = values_.size();
    values_.resize(values_.size() + static_cast<std::size_t>(f.count), f.factory);
  }
}

std::int64_t Settings::get(Setting id, int which) const {
  const SettingFact* f = fact(id);
  if (f == nullptr) return 0;
  return values_[places_[static_cast<std::size_t>(id)] + static_cast<std::size_t>(f->count == 1 ? 0 : which)];
}

void Settings::set(Setting id, std::int64_t value, int which) {
  const SettingFact* f = fact(id);
  if (f == nullptr) return;
  values_[places_[static_cast<std::size_t>(id)] + static_cast<std::size_t>(f->count == 1 ? 0 : which)] =
      value;
}

std::string Settings::text(const SettingFact& fact, std::int64_t value) const {
  const auto padded = [](std::int64_t n, std::size_t width) {
    std::string digits = std::to_string(n);
    return std::string(width - std::min(width, digits.size()), '0') + digits;
  };
  switch (fact.notation) {
    case Notation::name: return std::string(model_->name_prefix) + padded(value, 2);
    case Notation::thousandths: return std::to_string(value / 1000) + "." + padded(value % 1000, 3);
    case Notation::integer: break;
  }
  return std::to_string(value);
}

std::optional<std::int64_t> Settings::parse(const SettingFact& fact, std::string_view text) const {
  std::optional<std::int64_t> value;
  if (fact.notation == Notation::name) {
    const std::size_t prefix = model_->name_prefix.size();
    if (text.size() == prefix + 2 && text.substr(0, prefix) == model_->name_prefix &&
        digits_only(text.substr(prefix)))
      value = parse_integer(text.substr(prefix));
  } else {
    value = fact.notation == Notation::thousandths ? parse_thousandths(text) : parse_integer(text);
  }
  if (!value || (*value == 0 && fact.also_zero)) return value;
  if (*value < fact.min || *value > fact.max) return std::nullopt;
  return value;
}

void Settings::reset(bool stored_too) {
  for (const SettingFact& f : model_->settings)
    if (stored_too || !f.stored)
      for (int i = 0; i < f.count; ++i) set(f.id, f.factory, i);
}

void Settings::take_stored(const Settings& from) {
  for (const SettingFact& f : model_->settings)
    if (f.stored)
      for (int i = 0; i < f.count; ++i) set(f.id, from.get(f.id, i), i);
}

std::string Settings::name_of(const SettingFact& fact, int which) const {
  std::string name;
  for (const char c : fact.form) {
    if (c == 'a')
      name += model_->axis_letters[static_cast<std::size_t>(which)];
    else if (c == 'n')
      name += std::to_string(which + 1);
    else
      name += c;
  }
  return name;
}

void Settings::append_stored(std::string& lines) const {
  for (const SettingFact& f : model_->settings)
    if (f.stored)
      for (int i = 0; i < f.count; ++i) lines += name_of(f, i) + "=" + text(f, get(f.id, i)) + "\n";
}

bool Settings::load_line(std::string_view line) {
  const auto equals = line.find('=');
  if (equals == std::string_view::npos) return false;
  for (const SettingFact& f : model_->settings)
    for (int i = 0; f.stored && i < f.count; ++i) {
      if (line.substr(0, equals) != name_of(f, i)) continue;
      const auto value = parse(f, line.substr(equals + 1));
      if (value) set(f.id, *value, i);
      return value.has_value();
    }
  return false;
}

}  // namespace hw::arcus
