#include "core/devices/vxm/program_analysis.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace hw::vxm {
namespace {

std::size_t place(std::int64_t i) { return static_cast<std::size_t>(i); }

TokenKind kind_of(const Command& c) {
  if (moves(c)) return TokenKind::moves;
  if (is_loop(c.op) || c.op == Op::jump || c.op == Op::call || c.op == Op::call_pick) return TokenKind::flow;
  if (c.op != Op::user) return TokenKind::plain;
  const int u = c.value % slave_u_offset;
  const bool sets = (u >= 2 && u <= 5) || (u >= 14 && u <= 19) || u == 7 || u == 8 || u == 77;
  return sets ? TokenKind::plain : TokenKind::flow;
}

class Walk {
 public:
  explicit Walk(int slot) : slot_(slot) {}

  void line(std::string_view text) {
    text_ = text;
    base_ = reader_.place();
    LineReport report;
    report.first_command = size();
    report_ = &report;
    for (const char c : text) feed(c);
    feed('\r');
    report.slot = slot_;
    if (report.command_count == 0) report.first_command = -1;
    out_.report.lines.push_back(std::move(report));
    ran_ = false;
    ++number_;
  }

  Analysis finish() {
    if (group_) error(group_place_, "This ( is never closed by ).");
    if (bracket_) error(bracket_place_, "This [ is never closed by ].");
    for (const auto& [slot, commands] : out_.programs) {
      int bytes = 0;
      for (const StoredCommand& s : commands) {
        bytes += bytes_of(s.command);
        out_.report.listing[slot].push_back(listing_of(s.command));
      }
      out_.report.cost[slot] = bytes;
    }
    put_modes();
    out_.last_slot = slot_;
    return std::move(out_);
  }

 private:
  /// A text may set the controller as the Master of a Slave, or omit that: a rehearsal has a Slave if its
  /// motors need one.
  void put_modes() {
    const int master = out_.motors > motors_per_controller ? mode_master : 0;
    for (auto mode = modes_.rbegin(); mode != modes_.rend(); ++mode)
      out_.script.insert(mode->place, "setDM" + std::to_string((mode->value & ~mode_master) | master) + ",");
  }
  /// At a return: that of the line's end, or one inside the line in an old file.
  void end_remark(int end) {
    const int remark = std::exchange(remark_at_, -1);
    keep_before(remark);
    report_->tokens.push_back({remark, end, TokenKind::comment});
    if (ran_)
      warn({number_, remark, end - remark},
           "A remark after R is read as commands by the running program. Put it on another line.");
  }
  /// The reader ends the last command of a line at the return, behind the remark. For the user (and for a
  /// fix) the command ends with its last character.
  void keep_before(int remark) {
    const auto end_of = [&](int begin, int end) {
      end = std::min(end, remark);
      while (end > begin && text_[place(end - 1)] == ' ') --end;
      return end;
    };
    for (Token& t : report_->tokens)
      if (t.begin < remark) t.end = end_of(t.begin, t.end);
    for (Problem& p : out_.report.problems)
      if (p.line == number_ && p.column < remark) p.length = end_of(p.column, p.column + p.length) - p.column;
  }
  [[nodiscard]] int size() { return static_cast<int>(out_.programs[slot_].size()); }
  [[nodiscard]] std::string_view typed(const Reading& r) const {
    const auto from = std::max<std::int64_t>(r.begin - base_, 0);
    return text_.substr(std::min(place(from), text_.size()), place(r.end - r.begin));
  }
  [[nodiscard]] Place place_of(const Reading& r) const {
    return {number_, static_cast<int>(r.begin - base_), static_cast<int>(r.end - r.begin)};
  }
  void error(const Place& p, std::string sentence, std::string label = {}, std::string fix = {}) {
    out_.report.problems.push_back(
        {true, p.line, p.column, p.length, std::move(sentence), std::move(label), std::move(fix)});
  }
  void warn(const Place& p, std::string sentence) {
    out_.report.problems.push_back({false, p.line, p.column, p.length, std::move(sentence), {}, {}});
  }
  void token(const Place& p, TokenKind kind) {
    report_->tokens.push_back({p.column, p.column + p.length, kind});
  }

  void feed(char c) {
    const bool remark_before = reader_.in_comment();
    const auto column = static_cast<int>(reader_.place() - base_);
    const auto readings = reader_.feed(c);
    if (!remark_before && reader_.in_comment()) remark_at_ = column;
    for (const Reading& r : readings) take(r);
    if (remark_before && !reader_.in_comment()) end_remark(column);
    if (c == '\r' || (!remark_before && (c == ',' || c == '.'))) chunk_bad_ = false;
  }

  void take(const Reading& r) {
    switch (r.kind) {
      case Reading::Kind::letter: return letter(r);
      case Reading::Kind::word: return word(r);
      case Reading::Kind::no_number: return nonsense(r, true);
      case Reading::Kind::unknown:
        if (is_fraction(r)) return;
        [[fallthrough]];
      case Reading::Kind::broken: return nonsense(r, false);
    }
  }

  /// "I1M400.0": the period ends the number, and each digit behind it is dropped.
  bool is_fraction(const Reading& r) {
    const auto at = place(r.begin - base_);
    const auto is_number = [](char c) { return c >= '0' && c <= '9'; };
    if (chunk_bad_ || !is_number(r.letter) || at >= text_.size()) return false;
    std::size_t from = at, to = at + 1;
    while (from > 0 && is_number(text_[from - 1])) --from;
    while (to < text_.size() && is_number(text_[to])) ++to;
    if (from == 0 || text_[from - 1] != '.') return false;
    if (from < at) return true;  // reported at its first digit
    const Place p{number_, static_cast<int>(from) - 1, static_cast<int>(to - from) + 1};
    token(p, TokenKind::plain);
    warn(p, "The period ends the number: the fraction " + std::string(text_.substr(from - 1, to - from + 1)) +
                " is dropped.");
    return true;
  }

  /// One problem for each stretch between enders: text after a mistake is unintelligible too.
  void nonsense(const Reading& r, bool number_missing) {
    Place p = place_of(r);
    if (chunk_bad_) return;
    chunk_bad_ = r.kind != Reading::Kind::no_number;
    if (!number_missing) {
      const auto end = text_.find_first_of(",.;\r", place(std::max(p.column, 0)));
      p.length = static_cast<int>(std::min(end, text_.size())) - p.column;
    }
    std::string_view bad = text_.substr(place(p.column), place(p.length));
    while (!bad.empty() && bad.back() == ' ') bad.remove_suffix(1), --p.length;
    token(p, TokenKind::bad);
    out_.report.problems.push_back(problem_of_text(bad, p, number_missing));
    if (!bad.empty() && bad.back() == ')') group_.reset();  // reported once
  }

  void letter(const Reading& r) {
    if (chunk_bad_) return;
    const Place p = place_of(r);
    if (r.letter == ']' || bracket_) return bracket_letter(r, p);
    if (ran_) lost_after_run(p);
    token(p, r.letter == 'R' ? TokenKind::moves : TokenKind::plain);
    switch (r.letter) {
      case 'E':
      case 'F':
      case 'G': return;
      case 'R':
        ran_ = true;
        if (out_.run_slot >= 0)
          warn(p, "This is not the first R of the text. A rehearsal makes only one run, that of the last R.");
        out_.run_slot = slot_;
        return;
      case 'C':
        out_.programs[slot_].clear();
        report_->first_command = 0, report_->command_count = 0;
        out_.script += "C";
        return;
      case 'N': out_.script += "N"; return;
      case '(':
        if (group_) error(p, "One ( is inside another (.");
        group_ = Command(Op::group, 0, 0);
        group_place_ = p;
        return;
      case ')': return close_group(p);
      case '[':
        bracket_ = true, bracket_place_ = p;
        out_.motors = std::max(out_.motors, 3);
        out_.script += "[";
        return;
      default: warn(p, std::string(1, r.letter) + " acts at once and is not part of the program.");
    }
  }

  void bracket_letter(const Reading& r, const Place& p) {
    token(p, TokenKind::plain);
    if (!bracket_) return error(p, "This ] closes no [.");
    bracket_ = r.letter != ']';
    out_.script += r.letter;
  }

  void lost_after_run(const Place& p) {
    if (warned_after_run_) return;
    warned_after_run_ = true;
    warn(p, "Text after R on its line goes to the running program and is not stored.");
  }

  void word(const Reading& r) {
    if (chunk_bad_) return;
    const Place p = place_of(r);
    if (bracket_) {
      token(p, TokenKind::plain);
      out_.script += std::string(typed(r)) + ",";
      return;
    }
    if (ran_) lost_after_run(p);
    if (is_stored(r.head)) return stored(r, p);
    if (r.head == Head::PM && r.has_value) return heading(r, p);
    const bool asks = r.head >= Head::get_M || !(r.has_value || r.head == Head::set_D0);
    const bool sets = r.has_value && !asks;
    if (sets && !may_be_set(r)) {
      token(p, TokenKind::bad);
      return out_.report.problems.push_back(problem_of_setting(r, typed(r), p));
    }
    token(p, TokenKind::plain);
    warn(p, std::string(typed(r)) + (asks ? " asks the controller and is not part of the program."
                                          : " acts at once when it is sent and is not part of the program."));
    if (r.head == Head::del) {
      if (size() > 0) out_.programs[slot_].pop_back();
      out_.script += "del";
    }
    if (sets && r.head == Head::set_DM) {
      nf90_ = (r.value & mode_nf90) != 0;
      modes_.push_back({out_.script.size(), static_cast<int>(r.value)});
    } else if (sets && r.head != Head::set_B) {
      out_.script += std::string(typed(r)) + ",";
    }
    out_.motors = std::max(out_.motors, r.motor <= max_motors ? r.motor : 0);
  }

  void heading(const Reading& r, const Place& p) {
    token(p, TokenKind::flow);
    if (r.value >= program_count) {
      error(p, "There is no program " + std::to_string(r.value) + ". Programs are 0 to 4.");
      return;
    }
    slot_ = static_cast<int>(r.value);
    out_.has_headings = true;
    if (r.minus) out_.programs[slot_].clear();
    out_.programs[slot_];
    report_->first_command = size(), report_->command_count = 0;
    out_.script += "PM" + std::string(r.minus ? "-" : "") + std::to_string(slot_) + ",";
  }

  void stored(const Reading& r, const Place& p) {
    const auto what = meaning(r, motor_, nf90_);
    const Command* command = std::get_if<Command>(&what);
    if (command == nullptr) {
      token(p, TokenKind::bad);
      out_.report.problems.push_back(problem_of(r, std::get<Refusal>(what), typed(r), p, motor_));
      return;
    }
    token(p, kind_of(*command));
    if (command->motor != 0) motor_ = command->motor;
    const bool slave_io = command->op == Op::user && command->value >= slave_u_offset;
    out_.motors = std::max<int>(out_.motors, slave_io ? 3 : command->motor);
    if (!group_) {
      out_.script += listing_of(*command) + ",";
      return add(*command, p, bytes_of(*command));
    }
    if (!is_index(command->op)) return error(p, "Only indexes are allowed between ( and ).");
    group_->parts.push_back(*command);
    report_->cost += bytes_of(*command);
  }

  void close_group(const Place& p) {
    if (!group_) return error(p, "This ) closes no (.");
    const Command group = *group_;
    group_.reset();
    if (group.parts.empty()) return error(p, "There is nothing between ( and ).");
    const auto of_slave = [](const Command& c) { return c.motor > motors_per_controller; };
    const bool both = std::any_of(group.parts.begin(), group.parts.end(), of_slave) &&
                      !std::all_of(group.parts.begin(), group.parts.end(), of_slave);
    const Place whole{group_place_.line, group_place_.column,
                      group_place_.line == p.line ? p.column + 1 - group_place_.column : 1};
    if (!both)
      warn(whole, "Two motors of one controller never turn together: ( ) needs one of 1, 2 and one of 3, 4.");
    else if (!of_slave(group.parts.front()))
      warn(whole, "These run one after the other: inside ( ) the index of motor 3 or 4 must come first.");
    out_.script += listing_of(group);
    add(group, whole, pair_bytes);
  }

  void add(const Command& command, const Place& p, int cost) {
    out_.programs[slot_].push_back({command, p});
    report_->cost += cost;
    if (report_->command_count++ == 0) report_->first_command = size() - 1;
  }

  Analysis out_;
  Reader reader_;
  std::string_view text_;
  LineReport* report_ = nullptr;
  int number_ = 0, slot_ = 0, motor_ = 1, remark_at_ = -1;
  std::int64_t base_ = 0;
  std::optional<Command> group_;
  Place group_place_, bracket_place_;
  struct Mode {  ///< setDM: its place in the script
    std::size_t place = 0;
    int value = 0;
  };
  std::vector<Mode> modes_;
  bool nf90_ = false;
  bool bracket_ = false, ran_ = false, warned_after_run_ = false, chunk_bad_ = false;
};

}  // namespace

Analysis analyse_text(std::string_view text, int slot) {
  Walk walk(slot);
  for (std::size_t from = 0; from <= text.size();) {
    const auto end = std::min(text.find('\n', from), text.size());
    std::string_view line = text.substr(from, end - from);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (end == text.size() && line.empty() && from > 0) break;  // no line follows a final line end
    walk.line(line);
    from = end + 1;
  }
  return walk.finish();
}

}  // namespace hw::vxm
