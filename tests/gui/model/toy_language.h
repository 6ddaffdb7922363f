#pragma once
// A language for tests: commands separated by commas, each of two bytes; ';' begins a remark; "BAD" is an
// error that "GOOD" mends; "I..." moves, "L..." is flow; "PM-n" says which slot the following lines belong
// to.
#include <string>

#include "core/device/catalog.h"
#include "core/device/language.h"
#include "core/session/address.h"

namespace hw::test {

class ToyLanguage final : public Language {
 public:
  mutable int analysed = 0, rehearsed = 0;

  [[nodiscard]] ProgramReport analyse(std::string_view text, int slot) const override {
    ++analysed;
    ProgramReport report;
    int line = 0;
    report.cost[slot] = 0;
    for (std::size_t at = 0; at <= text.size(); ++line) {
      const auto end = std::min(text.find('\n', at), text.size());
      read_line(text.substr(at, end - at), line, slot, report);
      at = end + 1;
    }
    return report;
  }
  [[nodiscard]] Result<Rehearsal> rehearse(std::string_view text,
                                           const RehearseOptions& options) const override {
    ++rehearsed;
    if (text.find("BAD") != text.npos) return fail(FaultKind::text, "Line 1 cannot be understood.");
    Rehearsal r;
    r.duration_s = 68.6;
    r.finished = true;
    r.moves = 40;
    r.axes.push_back({"1", 4800, 0, 4800, 96000});
    r.axes.push_back({"2", 7600, 0, 7600, 7600});
    r.outputs["1"] = 0;
    r.sent_to_host = "^";
    r.program_size[std::to_string(options.slot)] = 27;
    return r;
  }
  [[nodiscard]] Result<SequenceText> write(const sequence::Sequence&, const Catalog&) const override {
    return SequenceText();
  }
  [[nodiscard]] Result<SequenceRead> read(std::string_view, const sequence::Sequence&,
                                          const Catalog&) const override {
    return fail(FaultKind::text, "Line 1: no block can represent this.");
  }

 private:
  static void read_line(std::string_view s, int line, int& slot, ProgramReport& report) {
    LineReport l;
    const auto remark = std::min(s.find(';'), s.size());
    for (std::size_t at = 0; at < remark;) {
      const auto end = std::min(s.find(',', at), remark);
      std::size_t first = at, last = end;
      while (first < last && s[first] == ' ') ++first;
      while (last > first && s[last - 1] == ' ') --last;
      if (first < last) take(s.substr(first, last - first), line, static_cast<int>(first), slot, l, report);
      at = end + 1;
    }
    if (remark < s.size())
      l.tokens.push_back({static_cast<int>(remark), static_cast<int>(s.size()), TokenKind::comment});
    l.slot = slot;
    report.cost[slot] += l.cost;
    report.lines.push_back(l);
  }
  static void take(std::string_view word, int line, int column, int& slot, LineReport& l,
                   ProgramReport& report) {
    const int length = static_cast<int>(word.size());
    if (word.starts_with("PM-")) {
      slot = word.back() - '0';
      return;
    }
    TokenKind kind = word[0] == 'I' ? TokenKind::moves : word[0] == 'L' ? TokenKind::flow : TokenKind::plain;
    if (word == "BAD") {
      kind = TokenKind::bad;
      report.problems.push_back({true, line, column, length, "BAD is no command.", "Use GOOD", "GOOD"});
    }
    l.tokens.push_back({column, column + length, kind});
    auto& listing = report.listing[slot];
    if (l.first_command < 0) l.first_command = static_cast<int>(listing.size());
    listing.emplace_back(word);
    ++l.command_count;
    l.cost += 2;
  }
};

inline ParamInfo toy_param(const char* mnemonic, const char* label, const char* group, std::int64_t low,
                           std::int64_t high, std::int64_t fallback, const char* unit = "") {
  ParamInfo p;
  p.mnemonic = mnemonic, p.label = label, p.group = group, p.unit = unit;
  p.explanation = std::string(label) + ", explained for a stranger.";
  p.minimum = low, p.maximum = high, p.fallback = fallback;
  return p;
}

inline Address toy_address() {
  Address a;
  a.model = "toy", a.transport = "emulator";
  return a;
}

inline Catalog toy_catalog() {
  Catalog c;
  c.model = "toy", c.name = "Toy Controller", c.short_name = "TOY";
  c.axes = {{"1", "motor 1"}, {"2", "motor 2"}};
  c.program.slots = 3, c.program.slot_word = "Program", c.program.capacity = 20,
  c.program.capacity_unit = "bytes";
  c.program.file_suffix = ".toy";
  c.can.store = true, c.can.store_life = 100000, c.can.single_step = true;
  ParamInfo motor = toy_param("M1M", "Type of motor 1", "Motors", 0, 2, 0);
  motor.choices = {{0, "0: none"}, {1, "1: small"}, {2, "2: big"}};
  motor.warning = "A wrong type can damage motor 1.";
  ParamInfo bits = toy_param("I", "What the inputs do", "Inputs", 0, 255, 7);
  bits.bits = {{0, "Run starts"}, {1, "Stop stops"}, {4, "hard stop"}};
  ParamInfo fleeting = toy_param("PMA", "Coupling", "Two controllers", 0, 255, 255);
  fleeting.stored = false;
  c.params = {motor, toy_param("j1M", "First jog speed of motor 1", "Jog buttons", 1, 6000, 2000, "steps/s"),
              bits, fleeting};
  c.command_separators = ",. ";
  c.commands = {{"SmMx", "S1M500", "speed of motor m", false, true, ""},
                {"ImMx", "I1M400", "move motor m by x steps", false, true, ""},
                {"R", "R", "run the program", true, false, ""},
                {"rsm", "rsm", "store all", false, false, ""},
                {"setMmMx", "setM1M4", "set the type of motor m", false, false, ""},
                {"setDMx", "setDM1", "set the mode", false, false, ""}};
  return c;
}

}  // namespace hw::test
