#include "core/devices/vxm/reply_kinds.h"

#include <functional>
#include <utility>

#include "core/base/number_text.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

bool is_state(std::string_view answer) { return decode_state(answer).has_value(); }
bool is_position(std::string_view answer) { return decode_position(answer).has_value(); }
bool is_unsigned(std::string_view answer) {  // reply to @: a position has a sign, a text a point
  return !answer.empty() && is_digit(answer.front()) && decode_number(answer);
}
bool is_version(std::string_view answer) {
  return answer.find('.') != std::string_view::npos && decode_text_line(answer);
}

// Outstanding replies come before the answer: whole lines of another form, and bytes that are no line.
template <bool (*fits)(std::string_view)>
std::size_t before_line(std::string_view received) {
  const std::size_t no_number = before_number(received);
  if (no_number > 0) return no_number;
  const auto end = received.find('\r');
  if (end == std::string_view::npos) return end;
  return fits(received.substr(0, end + 1)) ? 0 : end + 1;
}

// A second V, sent while the replies to a first V and to others are outstanding. In Local mode only V is
// answered, and the letter shows the mode. Otherwise replies come in order: the letter after a line asked for
// after the first V, or after another letter, answers the second V.
class SecondLetter {
 public:
  SecondLetter(const OutstandingReplies& outstanding, Instant now)
      : position_decides_(outstanding.comes_behind(reply_kind::position, reply_kind::letter, now)),
        number_decides_(outstanding.comes_behind(reply_kind::number, reply_kind::letter, now) &&
                        !outstanding.torn(now)) {}
  std::size_t operator()(std::string_view received) {
    if (before_number(received) == 0) {
      const auto end = received.find('\r');
      if (end == std::string_view::npos) return end;
      const std::string_view line = received.substr(0, end + 1);
      first_has_come_ = first_has_come_ || (position_decides_ && is_position(line)) ||
                        (number_decides_ && is_unsigned(line));
      return line.size();
    }
    if (const std::size_t others = before_state(received); others > 0) return others;
    const bool is_local = received.front() == jog_idle || received.front() == jog_moving;
    return is_local || std::exchange(first_has_come_, true) ? 0 : 1;
  }

 private:
  bool position_decides_, number_decides_;
  bool first_has_come_ = false;
};

using Fits = bool (*)(std::string_view);
Station::Unmistakable question(std::string text, ReplyShape shape, ReplyKind reply_kind, Fits fits,
                               std::function<std::size_t(std::string_view)> unsolicited_length) {
  Station::Unmistakable asked;
  asked.question = Transaction(std::move(text), shape, Priority::poll);
  asked.question.reply_kind = reply_kind;
  asked.question.unsolicited_length = std::move(unsolicited_length);
  asked.is_answer = fits;
  return asked;
}

}  // namespace

ReplyKind reply_kind_of(const TextCommand& c) {
  if (c.verb == Verb::word) return c.name == "lst" ? reply_kind::lines : reply_kind::prompt;
  if (c.verb == Verb::get) return c.name == "D0" || c.name == "D1" ? reply_kind::text : reply_kind::number;
  if (c.verb == Verb::ask_selected || c.verb == Verb::ask_associate) return reply_kind::number;
  if (c.verb != Verb::letter) return ReplyKind::any;
  switch (c.letter) {
    case 'V': return reply_kind::letter;
    case 'X':
    case 'Y':
    case 'Z':
    case 'T':
    case 'D': return reply_kind::position;
    case '@':
    case 'M': return reply_kind::number;
    case '?':
    case '~':
    case '$': return reply_kind::raw;
    case 'K': return reply_kind::prompt;
    default: return ReplyKind::any;
  }
}

// An outstanding raw byte may be one of the four letters. Then a letter is outstanding in its place. The next
// position skips it, and no raw byte counts meanwhile (Signals).
std::optional<Station::Unmistakable> unmistakable(const OutstandingReplies& outstanding, Instant now,
                                                  const Listening& listening, bool echoes) {
  if (listening.halted) return std::nullopt;
  const auto free = [&](ReplyKind reply_kind) { return !outstanding.may_be_outstanding(reply_kind, now); };
  if (free(reply_kind::letter) && free(reply_kind::lines))
    return question("V", ReplyShape::bytes(1), reply_kind::letter, is_state, before_state);
  if (listening.local) return std::nullopt;  // only V and D are answered
  if (free(reply_kind::position))
    return question("X", ReplyShape::line(), reply_kind::position, is_position, before_line<is_position>);
  const bool whole = !outstanding.torn(now);  // the end of a position looks like a number
  if (free(reply_kind::number) && free(reply_kind::lines) && whole &&
      !echoes) {  // the echo of @ is a message
    auto asked = question("@", ReplyShape::line(), reply_kind::number, is_unsigned, before_line<is_unsigned>);
    asked.question.may_be_silent = true;  // not answered in Local mode; the next question decides
    return asked;
  }
  if (free(reply_kind::lines))
    return question("V", ReplyShape::bytes(1), reply_kind::letter, is_state, SecondLetter(outstanding, now));
  if (free(reply_kind::text) && whole && !listening.running)
    return question("getD0", ReplyShape::line(), reply_kind::text, is_version, before_line<is_version>);
  return std::nullopt;
}

}  // namespace hw::vxm
