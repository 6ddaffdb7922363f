#include "gui/model/program_texts.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/device/transfer_progress.h"
#include "gui/model/units_format.h"

namespace hw::gui {

ProgramTexts::ProgramTexts(const ProgramFacts& facts, const Language* language)
    : language_(language),
      one_text_(facts.threads > 0),
      slots_(static_cast<std::size_t>(std::max(facts.slots, 1))) {}

void ProgramTexts::choose(int slot) {
  if (slot >= 0 && slot < count()) chosen_ = slot;
}

int ProgramTexts::start_of(int slot) {
  if (!one_text_) return slot;
  const std::vector<int>& there = report(slot).programs;
  if (std::find(there.begin(), there.end(), start_) != there.end()) return start_;
  return there.empty() ? 0 : there.front();
}

// ---- text

void ProgramTexts::set_text(int slot, std::string text) {
  Slot& s = at(slot);
  if (text == s.text) return;
  s.text = std::move(text);
  ++s.version;
  ++changes_;
}

const ProgramReport& ProgramTexts::report(int slot) {
  Slot& s = at(slot);
  if (s.analysed != s.version) {
    s.report = language_ ? language_->analyse(s.text, slot) : ProgramReport();
    s.analysed = s.version;
  }
  return s.report;
}

int ProgramTexts::cost(int slot) {
  const auto& costs = report(slot).cost;
  const auto found = costs.find(slot);
  return found == costs.end() ? 0 : found->second;
}

std::string_view line_of(std::string_view text, int line) {
  for (; line > 0; --line) {
    const std::size_t end = text.find('\n');
    if (end == text.npos) return {};
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  return text;
}

std::string first_error_line(const ProgramReport& report) {
  for (const Problem& p : report.problems)
    if (p.error) return fmt::format("line {}", p.line + 1);
  return {};
}

// ---- files

bool ProgramTexts::edited(int slot) const {
  const Slot& s = at(slot);
  return s.has_file ? s.text != s.in_file : !s.text.empty();
}

void ProgramTexts::opened(int slot, std::filesystem::path path, TextFile file) {
  Slot& s = at(slot);
  s.path = std::move(path);
  s.has_file = true;
  s.dos_lines = file.dos_lines;
  s.in_file = file.text;
  ++changes_;
  set_text(slot, std::move(file.text));
}

TextFile ProgramTexts::to_save(int slot) const {
  TextFile file;
  file.text = at(slot).text;
  file.dos_lines = at(slot).dos_lines;
  return file;
}

std::optional<std::string> ProgramTexts::known_in_file(int slot) const {
  return at(slot).has_file ? std::optional(at(slot).in_file) : std::nullopt;
}

void ProgramTexts::saved(int slot, std::filesystem::path path, std::string_view text) {
  Slot& s = at(slot);
  s.path = std::move(path);
  s.has_file = true;
  s.in_file = text;
  ++changes_;
}

std::vector<UnsavedText> ProgramTexts::unsaved() const {
  std::vector<UnsavedText> texts;
  for (int slot = 0; slot < count(); ++slot)
    if (edited(slot)) texts.push_back({slot, at(slot).text, at(slot).path.string()});
  return texts;
}

void ProgramTexts::restore(const std::vector<UnsavedText>& texts) {
  for (const UnsavedText& t : texts) {
    if (t.slot < 0 || t.slot >= count()) continue;
    at(t.slot).path = t.path;  // the name only: the file's content is not known, so the text counts as edited
    set_text(t.slot, t.text);
  }
}

// ---- contents of the controller

void ProgramTexts::hold(int slot, const std::string& text, bool from_here, Instant when) {
  Slot& s = at(slot);
  s.held.known = s.held.whole = true;
  s.held.runs_on = false;
  s.held.from_here = from_here;
  s.held.text = text;
  s.held.report = language_ ? language_->analyse(text, slot) : ProgramReport();
  const auto listing = s.held.report.listing.find(slot);
  s.held.listing = listing == s.held.report.listing.end() ? std::vector<std::string>() : listing->second;
  s.held.at = when;
  s.diffed = 0;
}

void ProgramTexts::loaded(int slot, const std::string& text, Instant when) {
  hold(slot, text, true, when);
  for (const auto& [other, listing] : at(slot).held.report.listing) {
    if (other == slot || other < 0 || other >= count()) continue;
    std::string lines;  // a text with headings fills other slots too
    for (const std::string& command : listing) lines += command + "\n";
    hold(other, lines, true, when);
  }
}

void ProgramTexts::listed(int slot, const std::string& listing, Instant when, bool whole) {
  if (slot < 0 || slot >= count()) return;
  const HeldProgram before = at(slot).held;
  hold(slot, listing, false, when);
  at(slot).held.whole = whole;
  if (!whole || !before.from_here || before.listing != at(slot).held.listing) return;
  at(slot).held = before;  // still the program loaded from here: keep its own text and time
  at(slot).held.known = true;
}

void ProgramTexts::cleared(int slot, Instant when) { hold(slot, "", false, when); }

void ProgramTexts::doubt() {
  for (Slot& s : slots_) {
    s.held.runs_on = s.held.runs_on || s.held.known;
    s.held.known = false;
  }
}

void ProgramTexts::forget() {
  for (Slot& s : slots_) s.held.known = s.held.runs_on = false;
}

void ProgramTexts::nothing_runs() {
  for (Slot& s : slots_) s.held.runs_on = false;
}

bool ProgramTexts::controller_has(int slot) {
  const HeldProgram& held = at(slot).held;
  if (!held.known || !held.whole) return false;
  if (report(slot).has_errors()) return false;  // its listing lacks the erroneous parts
  const auto& listings = report(slot).listing;
  const auto own = listings.find(slot);
  if (own == listings.end() ? !held.listing.empty() : own->second != held.listing) return false;
  for (const auto& [other, listing] : listings)
    if (other != slot && other >= 0 && other < count() &&
        (!at(other).held.known || at(other).held.listing != listing))
      return false;
  return true;
}

int ProgramTexts::live_line(int slot, int command) {
  Slot& s = at(slot);
  const HeldProgram& held = s.held;
  if (command < 0 || held.listing.empty() || !lines_known(slot)) return -1;
  const bool same_as_typed = !held.from_here && controller_has(slot);
  const ProgramReport& of = same_as_typed ? report(slot) : held.report;
  for (std::size_t line = 0; line < of.lines.size(); ++line) {
    const LineReport& l = of.lines[line];
    const bool here = l.first_command >= 0 && command >= l.first_command &&
                      command < l.first_command + l.command_count && (l.slot < 0 || l.slot == slot);
    if (!here) continue;
    if (same_as_typed) return static_cast<int>(line);
    if (s.diffed != s.version) {
      s.held_to_now = TextDiff(held.text, s.text);
      s.diffed = s.version;
    }
    return s.held_to_now.line_now(static_cast<int>(line));
  }
  return -1;
}

// ---- note

namespace {

/// For a controller that keeps no programs: the running one was sent from here.
ProgramNote note_of_sent(ProgramTexts& texts, int slot, bool runs, const std::string& mend,
                         std::string_view sent_at) {
  const HeldProgram& held = texts.held(slot);
  const bool changed = held.known && held.from_here && !texts.controller_has(slot);
  if (runs && changed)
    return {Severity::warn,
            fmt::format("The running program was sent at {}. The text has changed since. {}", sent_at,
                        mend.empty() ? "The next run sends it again."
                                     : fmt::format("Correct {} before the next run.", mend))};
  if (runs && held.known && held.from_here)
    return {Severity::plain, fmt::format("This text runs. It was sent at {}.", sent_at)};
  if (!mend.empty()) return {Severity::warn, fmt::format("Correct {} before the program can run.", mend)};
  if (texts.text(slot).empty()) return {};
  return {Severity::plain, "The controller keeps no programs: Run sends this text. Save keeps it in a file."};
}

/// Torn by a transfer that was broken off: the slots hold no complete program.
bool is_torn(const Snapshot& now, int slot, const ProgramFacts& facts) {
  return (now.slots_torn >> (facts.threads > 0 ? 0 : slot) & 1) != 0;
}

ProgramNote note_of_torn(const Snapshot& now, int slot, const ProgramFacts& facts, const std::string& mend) {
  const bool of_this = now.transfer.slot == (facts.threads > 0 ? 0 : slot);
  const std::string written = of_this ? report_written(now.transfer) : std::string();
  return {Severity::warn,
          fmt::format(
              "The controller does not hold this program{}{}. {}", written.empty() ? "" : ": ", written,
              mend.empty() ? "Run loads it again." : fmt::format("Correct {} before the next run.", mend))};
}

}  // namespace

ControllerState known_state(const ProgramTexts& texts, const Snapshot& now) {
  ControllerState state{now, {}};
  for (int slot = 0; slot < texts.count(); ++slot)
    if (texts.held(slot).known) state.programs[slot] = texts.held(slot).text;
  return state;
}

ProgramNote program_note(ProgramTexts& texts, int slot, const Snapshot& now, const ProgramFacts& facts,
                         std::string_view loaded_at) {
  const HeldProgram& held = texts.held(slot);
  const bool runs = now.program.owned && now.program.slot == slot && now.program.run != RunState::idle &&
                    now.program.run != RunState::error;
  const std::string verb = runs ? "runs" : "holds";
  const std::string mend = first_error_line(texts.report(slot));
  if (facts.capacity <= 0) return note_of_sent(texts, slot, runs, mend, loaded_at);
  if (is_torn(now, slot, facts)) return note_of_torn(now, slot, facts, mend);
  const int used = now.slot_bytes_used[static_cast<std::size_t>(slot)];
  if (held.known && held.from_here) {
    if (texts.controller_has(slot))
      return {Severity::plain, fmt::format("The controller {} this text, loaded at {}.", verb, loaded_at)};
    return {Severity::warn,
            fmt::format("The controller {} the text loaded at {}. It has changed since. {}", verb, loaded_at,
                        mend.empty() ? runs ? "The next run loads it again." : "Run loads it again."
                                     : fmt::format("Correct {} before the next run.", mend))};
  }
  if (held.known && !held.listing.empty() && texts.controller_has(slot))
    return {Severity::plain, fmt::format("The controller {} the same program as this text.", verb)};
  if (!mend.empty()) return {Severity::warn, fmt::format("Correct {} before the program can run.", mend)};
  if (used > 0 && texts.text(slot).empty())
    return {Severity::plain,
            fmt::format("{} {} in the controller holds {}. {} brings {} here.", facts.slot_word, slot,
                        count_of(used, facts.capacity_unit),
                        facts.compiled ? "Upload" : "Load from controller", used == 1 ? "it" : "them")};
  if (used > 0 && !held.known)
    return {
        Severity::plain,
        fmt::format("{} {} in the controller holds {}. Run compares {} with this text first.",
                    facts.slot_word, slot, count_of(used, facts.capacity_unit), used == 1 ? "it" : "them")};
  if (used > 0 && !held.whole)
    return {Severity::warn,
            "The controller also holds code that cannot be read here and is not in this text. Run asks "
            "before it overwrites."};
  if (used > 0)
    return {Severity::warn,
            fmt::format("{} {} in the controller holds another program of {}. Run asks before it "
                        "is overwritten.",
                        facts.slot_word, slot, count_of(used, facts.capacity_unit))};
  return {};
}

}  // namespace hw::gui
