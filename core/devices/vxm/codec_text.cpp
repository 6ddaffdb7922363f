#include "core/devices/vxm/codec_text.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/base/number_text.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

constexpr std::string_view single_letters = "QRNKCDEFGH!VXYZTxyM#*?~$@";
constexpr std::string_view words[] = {"lst", "rsm", "res", "del"};
constexpr int most_digits = 12;

bool is_dropped(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\0'; }

class Reader {
 public:
  Reader(std::string_view text, int motor) : text_(text), motor_(static_cast<std::uint8_t>(motor)) {}

  bool next(TextCommand& c) {
    skip_to_command();
    if (at_ >= text_.size()) return false;
    c = TextCommand();
    c.begin = at_;
    read(c);
    c.end = at_;
    return true;
  }

 private:
  // ---- characters

  void skip_dropped() {
    while (at_ < text_.size() && is_dropped(text_[at_])) ++at_;
  }
  void skip_remark() {
    while (at_ < text_.size() && text_[at_] != '\r') ++at_;
  }
  void skip_to_command() {
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == ';') skip_remark();
      if (at_ >= text_.size() || !(is_dropped(text_[at_]) || is_ender(text_[at_]))) return;
    }
  }
  /// Next character that counts, 0 at the end.
  char peek() {
    skip_dropped();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char wanted) {
    if (peek() != wanted) return false;
    ++at_;
    return true;
  }
  bool ended() { return peek() == '\0' && at_ >= text_.size(); }

  // ---- pieces of commands

  /// What is wrong when neither of the characters hoped for came: the character begins something new.
  void give_up(TextCommand& c) {
    c.flaw = ended() ? Flaw::open : is_ender(peek()) || peek() == ';' ? Flaw::no_value : Flaw::unknown;
    c.name = std::string(text_.substr(c.begin, std::max<std::size_t>(at_ - c.begin, 1)));
    if (at_ == c.begin) ++at_;
  }
  std::int64_t digits() {
    std::int64_t value = 0;
    for (int n = 0; is_digit(peek()); ++n, ++at_)
      if (n < most_digits) value = 10 * value + (text_[at_] - '0');
    return value;
  }
  /// The number has begun; what follows must end it.
  void end_number(TextCommand& c) {
    if (peek() == ';') skip_remark();
    if (ended()) return void(c.flaw = Flaw::open);
    if (is_ender(peek())) return void(++at_);
    while (at_ < text_.size() && !is_ender(text_[at_])) ++at_;
    if (at_ < text_.size()) ++at_;
    c.flaw = Flaw::unknown;
    c.name = std::string(text_.substr(c.begin, at_ - c.begin));
  }
  void number(TextCommand& c, bool may_be_negative = true) {
    if (may_be_negative) c.minus = take('-');
    if (!is_digit(peek())) return give_up(c);
    c.value = digits();
    end_number(c);
  }
  /// "1M" before the number, or a short form for the motor addressed last.
  void motor_and_number(TextCommand& c, bool may_be_negative) {
    if (is_digit(peek())) {
      const auto first = digits();
      if (!take('M')) {
        c.motor = motor_;
        c.value = first;
        return end_number(c);
      }
      c.motor = static_cast<std::uint8_t>(std::min<std::int64_t>(first, 99));
      number(c, may_be_negative);
    } else {
      c.motor = motor_;
      number(c, may_be_negative);
    }
    if (c.flaw == Flaw::none && c.motor >= 1 && c.motor <= max_motors) motor_ = c.motor;
  }
  /// For commands that act with or without a number.
  void optional_number(TextCommand& c, Verb with, Verb without) {
    if (is_ender(peek())) return ++at_, void(c.verb = without);
    if (peek() == ';') return skip_remark(), void(c.verb = without);
    if (ended()) return c.verb = without, void(c.flaw = Flaw::open);
    c.verb = with;
    number(c);
  }

  // ---- commands

  void read(TextCommand& c) {
    const char first = text_[at_++];
    switch (first) {
      case 'I': return index(c);
      case 'S': return speed(c);
      case 'A': return c.verb = Verb::acceleration, motor_and_number(c, false);
      case 'L': return loop(c);
      case 'J': return jump(c);
      case 'P': return program_or_pause(c);
      case 'U': return c.verb = Verb::user, number(c, false);
      case 'B': return c.name = "Bx", optional_number(c, Verb::set, Verb::get);
      case 'O': return c.name = "O", optional_number(c, Verb::set, Verb::get);
      case '(': return void(c.verb = Verb::pair_begins);
      case ')': return void(c.verb = Verb::pair_ends);
      case '[': return void(c.verb = Verb::slave_begins);
      case ']': return void(c.verb = Verb::slave_ends);
      case 's':
      case 'g': return setup(c, first);
      case 'l':
      case 'r':
      case 'd': return word(c, first);
      default: break;
    }
    c.letter = first;
    if (single_letters.find(first) == std::string_view::npos) {
      c.flaw = Flaw::unknown;
      c.name = std::string(1, first);
    }
  }
  void index(TextCommand& c) {
    const bool absolute = take('A');
    motor_and_number(c, true);
    if (absolute)
      c.verb = c.minus && c.value == 0 ? Verb::zero_here : Verb::index_to;
    else
      c.verb = c.value == 0 ? Verb::home : Verb::index_by;
  }
  void speed(TextCommand& c) {
    c.full_power = take('A');
    motor_and_number(c, true);
    c.verb = c.minus ? Verb::speed_analog : Verb::speed;
  }
  void loop(TextCommand& c) {
    if (take('M')) {
      number(c);
      c.verb = c.value != 0 ? Verb::loop_reverse : c.minus ? Verb::marker_reset : Verb::marker_set;
    } else if (take('A')) {
      c.verb = Verb::loop_always;
      number(c);
    } else {
      number(c);
      c.verb = c.value != 0 ? Verb::loop : c.minus ? Verb::marker_set : Verb::loop_forever;
    }
  }
  void jump(TextCommand& c) {
    if (!take('M')) return c.verb = Verb::jump, number(c, false);
    number(c);
    c.verb = c.minus ? Verb::jump_pick : Verb::jump_return;
  }
  void program_or_pause(TextCommand& c) {
    if (take('A')) return c.verb = Verb::pause_output, number(c);
    if (!take('M')) return c.verb = Verb::pause, number(c);
    if (take('A')) return optional_number(c, Verb::associate, Verb::ask_associate);
    optional_number(c, Verb::select, Verb::ask_selected);
    if (c.verb == Verb::select && c.minus) c.verb = Verb::empty;
  }
  void word(TextCommand& c, char first) {
    c.verb = Verb::word;
    for (const std::string_view w : words) {
      if (w[0] != first) continue;
      const std::size_t before = at_;
      if (take(w[1]) && take(w[2])) return void(c.name = w);
      if (ended()) return give_up(c);
      at_ = before;
    }
    take(first == 'r' ? 'e' : first == 'l' ? 's' : 'e');
    give_up(c);
    c.flaw = c.flaw == Flaw::no_value ? Flaw::unknown : c.flaw;
  }
  void setup(TextCommand& c, char first) {
    c.verb = first == 's' ? Verb::set : Verb::get;
    if (!take('e') || !take('t') || !mnemonic(c)) return give_up(c);
    if (c.verb == Verb::get) return;
    const std::string name = c.name;
    number(c);
    if (c.flaw != Flaw::unknown) c.name = name;
  }
  /// What stands between set/get and the value.
  bool mnemonic(TextCommand& c) {
    for (const char plain : {'B', 'I'})
      if (take(plain)) return c.name = plain, true;
    if (take('D')) {
      for (const char which : {'M', 'A'})
        if (take(which)) return c.name = std::string("D") + which, true;
      if (!is_digit(peek())) return false;
      if (c.verb == Verb::set) return c.name = "D", true;  // setD0: the 0 is the value
      return c.name = std::string("D") + text_[at_++], true;
    }
    for (const char which : {'j', 'J', 'L', 'M', 'P'}) {
      if (!take(which)) continue;
      std::string name(1, which);
      if (take('A')) name += 'A';
      if (name == "PA") return c.name = name, true;
      if (!is_digit(peek())) return false;
      c.motor = static_cast<std::uint8_t>(peek() - '0');
      name += text_[at_++];
      if (!take('M')) return false;
      return c.name = name + 'M', true;
    }
    return false;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::uint8_t motor_;
};

struct Range {
  std::int64_t low, high;
};

Range setup_range(const TextCommand& c) {
  if (c.name == "Bx") return {0, max_backlash};
  if (c.name == "O") return {0, max_limit_report};
  if (c.name == "D") return {0, 0};
  std::string pattern = c.name;
  for (char& letter : pattern)
    if (is_digit(letter)) letter = 'm';
  for (const SetupFact& fact : setup_facts)
    if (fact.mnemonic == pattern) return {fact.also_zero ? 0 : fact.min, fact.max};
  return {1, 0};
}

Range value_range(const TextCommand& c) {
  switch (c.verb) {
    case Verb::index_by: return {-max_index, max_index};
    case Verb::index_to: return {position_min, position_max};
    case Verb::speed: return {min_speed, max_speed};
    case Verb::acceleration: return {min_accel, max_accel};
    case Verb::loop:
    case Verb::loop_always: return c.minus ? Range{-max_loop, -min_loop} : Range{min_loop, max_loop};
    case Verb::loop_reverse: return {-3, -2};
    case Verb::jump:
    case Verb::jump_return:
    case Verb::select: return {0, program_count - 1};
    case Verb::empty:
    case Verb::jump_pick: return {-(program_count - 1), 0};
    case Verb::pause:
    case Verb::pause_output: return {-max_pause, max_pause};
    case Verb::set: return setup_range(c);
    default: return {-1'000'000'000'000, 1'000'000'000'000};
  }
}

template <class Table, class Of>
bool contains(const Table& table, std::int64_t value, Of of) {
  return std::any_of(table.begin(), table.end(), [&](const auto& row) { return of(row) == value; });
}

bool possible(const TextCommand& c) {
  const auto itself = [](int n) { return n; };
  const bool has_motor =
      c.verb <= Verb::acceleration || (c.name.size() > 1 && c.name.back() == 'M' && c.name != "DM");
  if (has_motor && (c.motor < 1 || c.motor > max_motors)) return false;
  const Range range = value_range(c);
  const auto value = c.signed_value();
  if (value < range.low || value > range.high) return false;
  switch (c.verb) {
    case Verb::speed_analog:
      return contains(analog_ranges, c.value, [](const AnalogRange& r) { return r.number; });
    case Verb::user: return contains(u_commands, value, itself) || contains(slave_u_commands, value, itself);
    case Verb::associate: return c.value <= program_count - 1 || (!c.minus && c.value == pma_off);
    case Verb::pause:
    case Verb::pause_output: return !(c.minus && c.value == 0);
    case Verb::set: return c.name != "B" || contains(bauds, value, [](const Baud& b) { return b.number; });
    default: return true;
  }
}

}  // namespace

std::vector<TextCommand> read_text(std::string_view text, int motor) {
  std::vector<TextCommand> all;
  Reader reader(text, motor);
  for (TextCommand c; reader.next(c); all.push_back(c))
    if (c.flaw == Flaw::none && !possible(c)) c.flaw = Flaw::range;
  return all;
}

bool ends_open(std::string_view text) {
  const auto all = read_text(text);
  // A number without its end, but also a spoilt command: the controller drops what follows up to an ender.
  if (all.empty()) return text.find(';') != std::string_view::npos && !text.ends_with('\r');
  const TextCommand& last = all.back();
  if (last.flaw == Flaw::open) return true;
  if (text.rfind(';') != std::string_view::npos && text.rfind(';') >= last.begin)
    return !text.ends_with('\r');
  return last.flaw == Flaw::unknown && last.end >= text.size() && last.end - last.begin > 1 &&
         !is_ender(text.back());
}

std::string canonical(const TextCommand& c) {
  if (c.flaw == Flaw::unknown) return c.name;
  const char* sign = c.minus ? "-" : "";
  const char* full = c.full_power ? "A" : "";
  const auto motor = int{c.motor};
  switch (c.verb) {
    case Verb::index_by:
    case Verb::home: return fmt::format("I{}M{}{}", motor, sign, c.value);
    case Verb::index_to:
    case Verb::zero_here: return fmt::format("IA{}M{}{}", motor, sign, c.value);
    case Verb::speed:
    case Verb::speed_analog: return fmt::format("S{}{}M{}{}", full, motor, sign, c.value);
    case Verb::acceleration: return fmt::format("A{}M{}", motor, c.value);
    case Verb::loop_forever: return "L0";
    case Verb::marker_set: return c.minus ? "L-0" : "LM0";
    case Verb::marker_reset: return "LM-0";
    case Verb::loop: return fmt::format("L{}{}", sign, c.value);
    case Verb::loop_always: return fmt::format("LA{}{}", sign, c.value);
    case Verb::loop_reverse: return fmt::format("LM{}{}", sign, c.value);
    case Verb::jump: return fmt::format("J{}", c.value);
    case Verb::jump_return:
    case Verb::jump_pick: return fmt::format("JM{}{}", sign, c.value);
    case Verb::pause: return fmt::format("P{}{}", sign, c.value);
    case Verb::pause_output: return fmt::format("PA{}{}", sign, c.value);
    case Verb::user: return fmt::format("U{}", c.value);
    case Verb::pair_begins: return "(";
    case Verb::pair_ends: return ")";
    case Verb::slave_begins: return "[";
    case Verb::slave_ends: return "]";
    case Verb::select:
    case Verb::empty: return fmt::format("PM{}{}", sign, c.value);
    case Verb::ask_selected: return "PM";
    case Verb::associate: return fmt::format("PMA{}{}", sign, c.value);
    case Verb::ask_associate: return "PMA";
    case Verb::set:
      if (c.name == "Bx" || c.name == "O") return fmt::format("{}{}", c.name[0], c.value);
      return fmt::format("set{}{}{}", c.name, sign, c.value);
    case Verb::get: return c.name == "Bx" || c.name == "O" ? c.name.substr(0, 1) : "get" + c.name;
    case Verb::letter: return std::string(1, c.letter);
    case Verb::word: return c.name;
  }
  return {};
}

// What stands before motor and number, as the table of costs names it.
static std::string_view head_of(const TextCommand& c) {
  switch (c.verb) {
    case Verb::index_by:
    case Verb::home: return "I";
    case Verb::index_to:
    case Verb::zero_here: return "IA";
    case Verb::speed:
    case Verb::speed_analog: return c.full_power ? "SA" : "S";
    case Verb::acceleration: return "A";
    case Verb::loop: return "L";
    case Verb::loop_always: return "LA";
    case Verb::marker_set:
    case Verb::marker_reset:
    case Verb::loop_reverse: return "LM";
    case Verb::jump:
    case Verb::jump_return:
    case Verb::jump_pick: return "J";
    case Verb::pause: return "P";
    case Verb::pause_output: return "PA";
    case Verb::user: return "U";
    default: return {};
  }
}

int program_cost(const TextCommand& c) {
  if (c.verb == Verb::loop_forever || (c.verb == Verb::marker_set && c.minus)) return endless_loop_bytes;
  if (c.verb == Verb::user && c.value == 91) return u91_bytes;
  if (c.verb == Verb::pair_begins) return pair_bytes;
  const std::string_view head = head_of(c);
  for (const StoredForm& form : stored_forms)
    if (form.head == head) return form.bytes;
  return 0;
}

std::string allowed_values(const TextCommand& c) {
  switch (c.verb) {
    case Verb::index_by: return fmt::format("1 to {} steps", max_index);
    case Verb::index_to: return fmt::format("{} to {} steps", position_min, position_max);
    case Verb::speed: return fmt::format("{} to {} steps/s", min_speed, max_speed);
    case Verb::speed_analog: return "a range of the manual's table, 1 to 6 or 11 to 51";
    case Verb::acceleration: return fmt::format("{} to {}", min_accel, max_accel);
    case Verb::loop:
    case Verb::loop_always: return fmt::format("{} to {} passes", min_loop, max_loop);
    case Verb::loop_reverse: return "-2 or -3";
    case Verb::jump:
    case Verb::jump_return:
    case Verb::jump_pick:
    case Verb::select:
    case Verb::empty: return fmt::format("program 0 to {}", program_count - 1);
    case Verb::pause:
    case Verb::pause_output: return fmt::format("0 to {}, or -1 to -{}", max_pause, max_pause);
    case Verb::user: return "one of the manual's U commands";
    case Verb::associate: return "0 to 4, -0 to -4, or 255";
    case Verb::set: {
      if (c.name == "B") return "9, 19 or 38";
      const Range r = setup_range(c);
      return r.low > r.high ? "nothing: there is no such setting" : fmt::format("{} to {}", r.low, r.high);
    }
    default: return {};
  }
}

}  // namespace hw::vxm
