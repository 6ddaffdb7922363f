#include "core/devices/vme58/command_text.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "core/base/number_text.h"

namespace hw::vme58 {
namespace {

bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }
bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ';' || c == ',' || c == '\0';
}
bool ends_list(char c) { return c == ';' || c == '\r' || c == '\n' || is_letter(c); }

bool reads_list(const CommandFact& fact, const Context& context) {
  return fact.shape == Shape::axes || fact.shape == Shape::ports ||
         (fact.shape == Shape::list && context.mode != where::single);
}
std::size_t places_of(const CommandFact& fact, const Context& context) {
  switch (fact.shape) {
    case Shape::none: return 0;
    case Shape::one: return 1;
    case Shape::list: return context.mode == where::single ? 1 : most_axes;
    case Shape::pair: return 2;
    case Shape::triple: return 3;
    case Shape::axes:
    case Shape::ports: return most_axes;
  }
  return 0;
}

class Reader {
 public:
  Reader(std::string_view text, Context& context) : text_(text), context_(context) {}

  std::vector<TextCommand> all() {
    while (at_ < text_.size()) {
      if (is_separator(text_[at_])) {
        ++at_;
        continue;
      }
      all_.push_back(read_one());
      follow(all_.back(), context_);
    }
    return std::move(all_);
  }

 private:
  TextCommand read_one() {
    TextCommand command;
    command.begin = at_;
    command.context = context_;
    const bool two = is_letter(text_[at_]) && at_ + 1 < text_.size() && is_letter(text_[at_ + 1]);
    if (!two) {
      skip_junk(command);
      return end(command);
    }
    command.fact = find_command(text_[at_], text_[at_ + 1], context_.modes());
    at_ += 2;
    if (!command.fact) {
      flaw(command, command.begin, 2, fmt::format("There is no command {}.", text_.substr(command.begin, 2)));
      skip_operands();
      return end(command);
    }
    read_numbers(command);
    return end(command);
  }

  TextCommand end(TextCommand& command) const {
    std::size_t stop = at_;
    while (stop > command.begin && is_separator(text_[stop - 1])) --stop;
    command.length = stop - command.begin;
    command.text = text_.substr(command.begin, command.length);
    return std::move(command);
  }

  static void flaw(TextCommand& command, std::size_t begin, std::size_t length, std::string why) {
    if (!command.flaw.empty()) return;
    command.flaw = std::move(why);
    command.flaw_begin = begin;
    command.flaw_length = std::max<std::size_t>(length, 1);
  }

  // Small letters, signs, digits without a command.
  void skip_junk(TextCommand& command) {
    const std::size_t begin = at_;
    const bool lone = is_letter(text_[at_]);
    do ++at_;
    while (at_ < text_.size() && !is_separator(text_[at_]) && !is_letter(text_[at_]));
    const std::string_view junk = text_.substr(begin, at_ - begin);
    flaw(command, begin, at_ - begin,
         lone ? fmt::format("{} is half a command: each command has two capital letters.", junk)
              : fmt::format("\"{}\" is not a command: each command begins with two capital letters.", junk));
  }
  void skip_operands() {
    while (at_ < text_.size() && !ends_list(text_[at_])) ++at_;
  }

  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  void read_numbers(TextCommand& command) {
    const std::size_t places = places_of(*command.fact, context_);
    const bool list = reads_list(*command.fact, context_);
    for (std::size_t place = 0; place < places; ++place) {
      skip_blanks();
      const std::size_t before = at_;
      const auto number = read_number(command);
      if (!number && at_ != before) return;  // junk
      if (!number && (at_ >= text_.size() || text_[at_] != ',')) {
        if (!list && place < places)
          flaw(command, command.begin, at_ - command.begin,
               places == 1 ? fmt::format("{} needs a number.", command.fact->letters)
                           : fmt::format("{} needs {} numbers.", command.fact->letters, places));
        break;
      }
      command.numbers.push_back(number);
      const std::size_t behind = at_;
      skip_blanks();
      if (at_ >= text_.size() || text_[at_] != ',' || place + 1 == places) {
        at_ = behind;
        if (!list && place + 1 < places)
          flaw(command, command.begin, at_ - command.begin,
               fmt::format("{} needs {} numbers.", command.fact->letters, places));
        break;
      }
      ++at_;
    }
    if (places > 0 && list && command.given() == 0)
      flaw(command, command.begin, at_ - command.begin,
           fmt::format("{} needs at least one number.", command.fact->letters));
    if (const int axes = std::popcount(context_.contour_axes); command.is(Op::CR) && axes != 2)
      flaw(command, command.begin, at_ - command.begin,
           fmt::format("CR needs a contour of two axes, and this contour has {}.", axes));
  }

  std::optional<double> read_number(TextCommand& command) {
    const std::size_t begin = at_;
    std::size_t end = at_;
    if (end < text_.size() && text_[end] == '-') ++end;
    const std::size_t digits = end;
    while (end < text_.size() && is_digit(text_[end])) ++end;
    if (end < text_.size() && text_[end] == '.') ++end;
    while (end < text_.size() && is_digit(text_[end])) ++end;
    const std::string word(text_.substr(begin, end - begin));
    const bool some = std::any_of(word.begin(), word.end(), is_digit);
    if (!some && end == begin) {
      const bool other = at_ < text_.size() && !is_separator(text_[at_]) && !is_letter(text_[at_]);
      if (!other) return std::nullopt;
    }
    if (!some) {
      while (end < text_.size() && !is_separator(text_[end]) && !is_letter(text_[end])) ++end;
      end = std::max(end, digits);
      flaw(command, begin, end - begin,
           fmt::format("\"{}\" is not a number.", text_.substr(begin, end - begin)));
      at_ = std::max(end, begin + 1);
      return std::nullopt;
    }
    at_ = end;
    return std::strtod(word.c_str(), nullptr);
  }

  std::string_view text_;
  Context& context_;
  std::size_t at_ = 0;
  std::vector<TextCommand> all_;
};

}  // namespace

std::string Context::selector() const {
  if (mode == where::all) return "AA";
  if (mode == where::tasks) return "AM";
  return std::string("A") + axis_letters[static_cast<std::size_t>(axis)];
}

std::size_t TextCommand::given() const {
  return static_cast<std::size_t>(
      std::count_if(numbers.begin(), numbers.end(), [](const auto& n) { return n.has_value(); }));
}

std::vector<TextCommand> read_commands(std::string_view text, Context& context) {
  return Reader(text, context).all();
}

bool begins_motion(Op op) {
  switch (op) {
    case Op::GO:
    case Op::GD:
    case Op::JG:
    case Op::JF:
    case Op::HM:
    case Op::HR:
    case Op::KM:
    case Op::KR: return true;
    default: return false;
  }
}

bool selects(const TextCommand& command) {
  return command.fact && ((command.fact->op >= Op::AX && command.fact->op <= Op::AS) || command.is(Op::AA) ||
                          command.is(Op::AM));
}

std::string without_comments(std::string_view text) {
  std::string plain(text);
  bool comment = false;
  for (char& c : plain) {
    comment = c != '\n' && (comment || c == '#');
    if (comment || c == '\t') c = ' ';
  }
  return plain;
}

void follow(const TextCommand& command, Context& context) {
  if (!command.fact || !command.flaw.empty()) return;
  const Op op = command.fact->op;
  if (op >= Op::AX && op <= Op::AS) {
    context.mode = where::single;
    context.axis = static_cast<int>(op) - static_cast<int>(Op::AX);
    context.recording = false;
  } else if (op == Op::AA || op == Op::AM) {
    context.mode = op == Op::AA ? where::all : where::tasks;
    context.recording = false;
  } else if (op == Op::CD && context.mode != where::single) {
    context.recording = true;
    context.contour_axes = 0;
    for (std::size_t i = 0; i < command.numbers.size(); ++i)
      if (command.numbers[i]) context.contour_axes |= 1u << i;
  } else if (op == Op::CE || op == Op::CK) {
    context.recording = false;
  } else if (op == Op::RS) {
    context = Context();
  }
}

}  // namespace hw::vme58
