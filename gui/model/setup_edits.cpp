#include "gui/model/setup_edits.h"

#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "gui/model/lower_case.h"
#include "gui/model/units_format.h"

namespace hw::gui {

SetupEdits::SetupEdits(const Catalog& catalog) : catalog_(catalog), edits_(catalog.params.size()) {
  for (const ParamInfo& p : catalog.params)
    searched_.push_back(
        lower_case(fmt::format("{}\n{}\n{}\n{}\n{}", p.mnemonic, p.label, p.group, p.explanation, p.unit)));
}

bool SetupEdits::set(std::size_t i, std::int64_t value, std::string* why) {
  const ParamInfo& p = catalog_.params[i];
  if (!p.accepts(value)) {
    if (why)
      *why = fmt::format("{} takes {}. {} was not accepted.", p.mnemonic, range_in_words(p),
                         value_text(p, value));
    return false;
  }
  edits_[i] = value;
  return true;
}

std::optional<std::int64_t> SetupEdits::shown(std::size_t i, const Snapshot& now) const {
  if (edits_[i]) return edits_[i];
  if (now.params[i].known) return now.params[i].value;
  return std::nullopt;
}

bool SetupEdits::changed(std::size_t i, const Snapshot& now) const {
  return edits_[i] && (!now.params[i].known || now.params[i].value != *edits_[i]);
}

bool SetupEdits::off_factory(std::size_t i, const Snapshot& now) const {
  const auto value = shown(i, now);
  return value && *value != catalog_.params[i].fallback;
}

std::vector<std::size_t> SetupEdits::to_send(const Snapshot& now) const {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < edits_.size(); ++i)
    if (changed(i, now)) list.push_back(i);
  return list;
}

int SetupEdits::changes(const Snapshot& now) const {
  int n = 0;
  for (std::size_t i = 0; i < edits_.size(); ++i) n += changed(i, now);
  return n;
}

void SetupEdits::settle(const Snapshot& now) {
  for (std::size_t i = 0; i < edits_.size(); ++i)
    if (edits_[i] && now.params[i].known && now.params[i].value == *edits_[i]) edits_[i].reset();
}

std::vector<std::string> SetupEdits::take(const CheckedBackup& file, const Snapshot& now, int* differing) {
  int n = 0;
  for (const ParameterEntry& entry : file.parameters) {
    const auto i = static_cast<std::size_t>(catalog_.find_param(entry.mnemonic));
    edits_[i] = entry.value;
    if (changed(i, now))
      ++n;
    else
      edits_[i].reset();
  }
  if (differing) *differing = n;
  return file.problems;
}

Backup SetupEdits::to_file(const Snapshot& now) const {
  Backup file;
  file.model = catalog_.model;
  file.firmware = std::string(now.identity.firmware.view());
  for (std::size_t i = 0; i < edits_.size(); ++i)
    if (const auto value = shown(i, now)) file.parameters.push_back({catalog_.params[i].mnemonic, *value, 0});
  return file;
}

bool SetupEdits::matches(std::size_t i, std::string_view filter) const {
  const std::string wanted = lower_case(filter);
  std::string_view rest = wanted;
  while (!rest.empty()) {
    const auto end = std::min(rest.find(' '), rest.size());
    if (searched_[i].find(rest.substr(0, end)) == std::string::npos) return false;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return true;
}

// ---- writing

void SetupWrite::begin(const SetupEdits& edits, const Snapshot& now, const Catalog& catalog, bool confirmed,
                       const Send& send) {
  if (busy()) return;
  values_.clear();
  next_ = 0;
  confirmed_ = confirmed;
  for (const std::size_t i : edits.to_send(now)) values_.emplace_back(i, *edits.edited(i));
  if (busy()) send_next(catalog, send);
}

void SetupWrite::send_next(const Catalog& catalog, const Send& send) {
  const auto& [i, value] = values_[next_];
  waiting_for_ = send(intent::SetParam(catalog.params[i].mnemonic, value, confirmed_));
}

std::string SetupWrite::store_words(const Catalog& catalog) const {
  const auto kept = static_cast<std::size_t>(std::count_if(
      values_.begin(), values_.end(), [&](const auto& value) { return catalog.params[value.first].stored; }));
  const bool one = values_.size() == 1;
  if (kept == 0) return one ? "It is lost at power-off." : "They are lost at power-off.";
  if (kept < values_.size()) return fmt::format("Store keeps {} of them at power-off.", kept);
  return fmt::format("Store keeps {} at power-off.", one ? "it" : "them");
}

void SetupWrite::update(const Snapshot& now, const Catalog& catalog, const Send& send) {
  if (!busy()) return;
  const auto ended = [&](bool good, std::string sentence) {
    report_ = {good, std::move(sentence)};
    values_.clear();
    next_ = 0;
  };
  if (now.link.state == LinkState::lost || now.link.state == LinkState::closed)
    return ended(false,
                 fmt::format("The link was lost: {} of {} values were written.", next_, values_.size()));
  if (now.forgotten(waiting_for_))
    return ended(false, fmt::format("The outcome for a value is not known: {} of {} values were written.",
                                    next_, values_.size()));
  const IntentOutcome* outcome = now.outcome_of(waiting_for_);
  if (!outcome || outcome->state == IntentState::pending) return;
  if (outcome->state != IntentState::done) {
    const ParamInfo& p = catalog.params[values_[next_].first];
    if (outcome->asks)  // a dialog asks, and sends it
      return ended(false, fmt::format("Answer the question about {} first. {} of {} values were written.",
                                      p.mnemonic, next_, values_.size()));
    return ended(false, fmt::format("{}: {} {} of {} values were written.", p.mnemonic,
                                    outcome->sentence.view(), next_, values_.size()));
  }
  ++next_;
  if (busy()) return send_next(catalog, send);
  ended(true, fmt::format("{} value{} written and read back. In force now; {}", values_.size(),
                          values_.size() == 1 ? "" : "s", store_words(catalog)));
}

std::string value_text(const ParamInfo& p, std::int64_t value) {
  if (!p.prefix.empty() || p.digits > 0) return fmt::format("{}{:0{}}", p.prefix, value, p.digits);
  if (p.decimals > 0)
    return fmt::format("{:.{}f}", static_cast<double>(value) / std::pow(10.0, p.decimals), p.decimals);
  return fmt::format("{}", value);
}

std::string range_in_words(const ParamInfo& p) {
  if (!p.choices.empty()) return range_of(p);
  return fmt::format("{}{} to {}", p.also_zero && p.minimum > 0 ? "0 or " : "", value_text(p, p.minimum),
                     value_text(p, p.maximum));
}

std::string unit_of(const ParamInfo& p, const Catalog& catalog, const Snapshot& now) {
  return p.follows_loop ? counted_unit(catalog, now, p.unit, p.axis) : p.unit;
}

std::string value_in_words(const ParamInfo& p, std::int64_t value) {
  for (const ParamChoice& c : p.choices)
    if (c.value == value) return c.label;
  if (!p.bits.empty()) {
    std::string names;
    for (const ParamBit& b : p.bits)
      if (value >> b.bit & 1) names += (names.empty() ? "" : ", ") + b.label;
    return fmt::format("{} ({})", value, names.empty() ? "nothing" : names);
  }
  return p.unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, p.unit);
}

}  // namespace hw::gui
