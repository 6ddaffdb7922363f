#include "panels/control/shown_unit.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "gui/model/setup_edits.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr int most_decimals = 6;

/// The quantity of a number of the catalog.
struct OwnNumber {
  std::string_view unit;
  int axis, decimals;
  bool follows_loop;
  bool is_signed;  ///< true: the sign is a direction; false: an amount
};

/// The suffix after the step unit: "" for a position, "/s" for a speed; nullopt for other units.
std::optional<std::string_view> behind_step(const Catalog& c, std::string_view unit) {
  if (!unit.starts_with(c.step_word)) return {};
  const std::string_view rest = unit.substr(c.step_word.size());
  return rest.empty() || rest.front() == '/' ? std::optional(rest) : std::nullopt;
}

ShownUnit shown_as(const Frame& f, const OwnNumber& own) {
  ShownUnit u;
  u.decimals = u.own_decimals = own.decimals;
  const auto rest = behind_step(f.catalog, own.unit);
  if (own.axis >= 0 && rest) {
    const DisplayUnit& chosen = f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(own.axis)});
    if (chosen.real) {
      u.name = chosen.name;
      u.name += *rest;
      u.per = own.is_signed ? chosen.per_step : std::abs(chosen.per_step);
      u.decimals = std::min(most_decimals, chosen.decimals + own.decimals);
      return u;
    }
  }
  u.name = own.follows_loop ? counted_unit(f.catalog, f.now, own.unit, own.axis) : std::string(own.unit);
  return u;
}

}  // namespace

double ShownUnit::shown(std::int64_t value) const {
  return static_cast<double>(value) / std::pow(10.0, own_decimals) * per;
}

std::int64_t ShownUnit::value(double shown) const {
  return std::llround(shown / per * std::pow(10.0, own_decimals));
}

ShownUnit shown_unit(const Frame& f, const ParamInfo& p) {
  return shown_as(f, {p.unit, p.axis, p.decimals, p.follows_loop, p.minimum < 0});
}

ShownUnit shown_unit(const Frame& f, const ReadoutInfo& r) {
  return shown_as(f, {r.unit, r.axis, 0, false, true});
}

ShownUnit shown_unit(const Frame& f, const ActionField& field, int axis) {
  return shown_as(f, {field.unit, axis, field.decimals, field.follows_loop, field.minimum < 0});
}

std::string text_in(const ShownUnit& unit, const ParamInfo& p, std::int64_t value) {
  if (!p.prefix.empty() || p.digits > 0 || !p.choices.empty() || !p.bits.empty()) return value_text(p, value);
  return std::string(format_number(unit.shown(value), unit.decimals).view());
}

std::string range_in(const ShownUnit& unit, const ParamInfo& p) {
  if (!p.choices.empty()) return range_in_words(p);
  const std::string a = text_in(unit, p, p.minimum), b = text_in(unit, p, p.maximum);
  const bool turned = unit.per < 0;
  return (p.also_zero && p.minimum > 0 ? "0 or " : "") + (turned ? b : a) + " to " + (turned ? a : b);
}

bool UnitsOfRows::has(std::string_view name) const {
  for (std::string_view rest = view(); !rest.empty();) {
    const std::size_t end = std::min(rest.find(", "), rest.size());
    if (rest.substr(0, end) == name) return true;
    rest.remove_prefix(std::min(rest.size(), end + 2));
  }
  return false;
}

void UnitsOfRows::add(std::string_view name) {
  if (name.empty() || has(name) || size_ + name.size() + 2 > sizeof bytes_) return;
  if (size_ > 0) std::memcpy(bytes_ + size_, ", ", 2), size_ += 2;
  std::memcpy(bytes_ + size_, name.data(), name.size());
  size_ += name.size();
}

}  // namespace hw::panels
