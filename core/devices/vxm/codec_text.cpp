#include "core/devices/vxm/codec_text.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

constexpr std::string_view single_letters = "QRNKCDEFGH!VXYZTxyM#*?~$@";
constexpr std::string_view words[] = {"lst", "rsm", "res", "del"};
constexpr int most_digits = 12;

bool is_dropped(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\0'; }

class TextReader {
 public:
  TextReader(std::string_view text, int motor) : text_(text), motor_(static_cast<std::uint8_t>(motor)) {}

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
  /// The next character that is not ignored; 0 at the end.
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

  /// Marks the command as spoilt: an unexpected character came, which begins a new command.
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
  /// The number has begun: the next character must end it.
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
  /// The text between set/get and the value.
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

}  // namespace

std::vector<TextCommand> read_text(std::string_view text, int motor) {
  std::vector<TextCommand> all;
  TextReader reader(text, motor);
  for (TextCommand c; reader.next(c); all.push_back(c))
    if (c.flaw == Flaw::none && !possible(c)) c.flaw = Flaw::range;
  return all;
}

std::vector<TextCommand> commands_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\r';
  return read_text(text);
}

bool ends_open(std::string_view text) {
  const auto all = read_text(text);
  // A number without its ender, or a spoilt command: the controller drops the rest up to an ender.
  if (all.empty()) return text.find(';') != std::string_view::npos && !text.ends_with('\r');
  const TextCommand& last = all.back();
  if (last.flaw == Flaw::open) return true;
  if (text.rfind(';') != std::string_view::npos && text.rfind(';') >= last.begin)
    return !text.ends_with('\r');
  return last.flaw == Flaw::unknown && last.end >= text.size() && last.end - last.begin > 1 &&
         !is_ender(text.back());
}

}  // namespace hw::vxm
