#include "core/devices/vme58/emulator_parser.h"

#include <charconv>

#include "core/base/index.h"
#include "core/base/number_text.h"

namespace hw::vme58 {
namespace {

constexpr std::size_t longest_number = 40;

constexpr bool is_command_letter(char c) { return c >= 'A' && c <= 'Z'; }
constexpr bool ends_line(char c) { return c == ';' || c == '\r' || c == '\n'; }
constexpr bool separates(char c) { return c == ' ' || c == ',' || ends_line(c); }
constexpr bool is_number_part(char c) { return is_digit(c) || c == '-' || c == '.'; }

/// -12, 12.5, .5, 12. but no exponent, no plus sign and no second point (decision M15).
std::optional<double> parse_number(std::string_view text) {
  std::size_t i = 0;
  int digits = 0, points = 0;
  if (!text.empty() && text[0] == '-') ++i;
  for (; i < text.size(); ++i) {
    if (is_digit(text[i]))
      ++digits;
    else if (text[i] != '.' || ++points > 1)
      return std::nullopt;
  }
  if (digits == 0) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

Parser::Outcome Parser::push(char c, unsigned modes) {
  switch (state_) {
    case State::idle: return begin(c);
    case State::second_letter: return second(c, modes);
    case State::numbers: return number(c);
    case State::skipping: break;
  }
  // After text that was no command: its numbers are skipped with it.
  if (ends_line(c)) state_ = State::idle;
  if (is_command_letter(c)) return begin(c);
  return {};
}

Parser::Outcome Parser::begin(char c) {
  if (is_command_letter(c)) {
    first_ = c;
    state_ = State::second_letter;
    return {};
  }
  state_ = State::idle;
  if (separates(c)) return {};
  return junk();
}

Parser::Outcome Parser::junk() {
  state_ = State::skipping;
  return {.error = true, .command = {}};
}

Parser::Outcome Parser::second(char c, unsigned modes) {
  if (!is_command_letter(c)) {
    const Outcome error = junk();
    if (ends_line(c)) state_ = State::idle;
    return error;
  }
  const bool is_kk = knows_kk_ && first_ == oms_kk.letters[0] && c == oms_kk.letters[1];
  const CommandFact* fact = is_kk ? &oms_kk : find_command(first_, c, modes);
  if (fact == nullptr || (fact->where & modes) == 0) return junk();
  command_ = Command();
  command_.fact = fact;
  modes_ = modes;
  if (fact->shape == Shape::none) {
    state_ = State::idle;
    return {.error = false, .command = command_};
  }
  place_ = 0;
  text_.clear();
  closed_ = false;
  state_ = State::numbers;
  return {};
}

bool Parser::takes_list() const {
  const Shape s = command_.fact->shape;
  if (s == Shape::list) return (modes_ & where::single) == 0;
  return s == Shape::axes || s == Shape::ports;
}

int Parser::places() const {
  switch (command_.fact->shape) {
    case Shape::pair: return 2;
    case Shape::triple: return 3;
    default: return takes_list() ? most_axes : 1;
  }
}

Parser::Outcome Parser::number(char c) {
  if (is_number_part(c)) {
    if (closed_ || text_.size() >= longest_number) return junk();
    text_ += c;
    return {};
  }
  if (c == ' ') {
    if (text_.empty()) return {};
    if (!takes_list() && place_ + 1 == places()) return finish();
    closed_ = true;
    return {};
  }
  if (c == ',') return next_place();
  if (ends_line(c)) return finish();
  if (is_command_letter(c)) {
    const Outcome done = finish();
    (void)begin(c);
    return done;
  }
  return junk();
}

bool Parser::keep_number() {
  const auto value = parse_number(text_);
  if (!value) return false;
  command_.number[ix(place_)] = *value;
  text_.clear();
  closed_ = false;
  return true;
}

Parser::Outcome Parser::next_place() {
  const bool skipped = text_.empty() && takes_list();
  if (!skipped && !takes_list() && place_ + 1 == places()) return finish();
  if (!skipped && !keep_number()) return junk();
  if (++place_ >= places()) return junk();
  return {};
}

Parser::Outcome Parser::finish() {
  state_ = State::idle;
  const bool nothing_typed = text_.empty();
  if (!nothing_typed && !keep_number()) return {.error = true, .command = {}};
  const int given = command_.operands();
  const bool enough = takes_list() ? given > 0 : given == places();
  if (!enough) return {.error = true, .command = {}};
  return {.error = false, .command = command_};
}

}  // namespace hw::vme58
