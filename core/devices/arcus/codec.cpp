#include "core/devices/arcus/codec.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/base/number_text.h"

namespace hw::arcus {
namespace {

bool ends_text(char c) { return c == '\r' || c == '\n' || c == '\0'; }

std::string_view letter(const Model& model, int axis) {
  return model.axis_letters.substr(static_cast<std::size_t>(axis), 1);
}

}  // namespace

std::string frame(Framing framing, int id, std::string_view text) {
  if (framing == Framing::message) return std::string(text);
  if (address_of(text) >= 0) return fmt::format("{}\r", text);
  return fmt::format("@{:02}{}\r", id, text);
}

int address_of(std::string_view bytes) {
  if (bytes.size() < 3 || bytes[0] != '@' || !is_digit(bytes[1]) || !is_digit(bytes[2])) return -1;
  return (bytes[1] - '0') * 10 + bytes[2] - '0';
}

std::string_view text_of(std::string_view bytes) {
  while (!bytes.empty() && ends_text(bytes.front())) bytes.remove_prefix(1);
  if (const auto end = bytes.find_first_of(std::string_view("\r\n\0", 3)); end != bytes.npos)
    bytes = bytes.substr(0, end);
  if (address_of(bytes) >= 0) bytes.remove_prefix(3);
  return bytes;
}

Reply decode_reply(std::string_view bytes) {
  Reply reply;
  std::string_view text = text_of(bytes);
  if (text.size() >= 3 && text[0] == '#' && is_digit(text[1]) && is_digit(text[2])) {
    reply.id = (text[1] - '0') * 10 + text[2] - '0';
    text.remove_prefix(3);
  }
  reply.text = text;
  return reply;
}

namespace {

// Number of bytes at the front that match: the whole pattern; npos if more bytes are needed to decide; or 0.
// In the pattern d is a digit, | the end of a text.
std::size_t fit_at_front(std::string_view bytes, std::string_view pattern) {
  const std::size_t length = std::min(bytes.size(), pattern.size());
  for (std::size_t i = 0; i < length; ++i) {
    const char c = bytes[i], p = pattern[i];
    const bool fits = p == 'd' ? is_digit(c) : p == '|' ? c == '\r' || c == '\0' : c == p;
    if (!fits) return 0;
  }
  return length == pattern.size() ? length : std::string_view::npos;
}

}  // namespace

std::size_t unsolicited_at_front(std::string_view bytes) { return fit_at_front(bytes, "$ddP\r"); }

std::size_t refusal_of_cut_at_front(std::string_view bytes) {
  constexpr std::size_t id = 3;  // #NN
  const std::string_view text = bytes.starts_with('#') ? bytes.substr(std::min(id, bytes.size())) : bytes;
  if (text.empty()) return bytes.empty() ? 0 : std::string_view::npos;
  if (!text.starts_with('?')) return 0;
  const auto end = bytes.find_first_of(std::string_view("\r\0", 2));
  if (end == bytes.npos) return bytes.npos;
  return bytes[end - 1] == cut_off.front() ? end + 1 : 0;
}

std::size_t unsolicited_or_name_at_front(const Model& model, std::string_view bytes) {
  const std::string name = std::string(model.name_prefix) + "dd|";
  std::size_t found = 0;
  for (const std::string& pattern : {std::string("$ddP\r"), name, "#dd" + name}) {
    const std::size_t fits = fit_at_front(bytes, pattern);
    if (fits != 0 && fits != std::string_view::npos) return fits;
    found = std::max(found, fits);
  }
  return found;
}

std::optional<int> number_in_name(const Model& model, std::string_view name) {
  if (name.size() != model.name_prefix.size() + 2 || !name.starts_with(model.name_prefix))
    return std::nullopt;
  return whole_number<int>(name.substr(model.name_prefix.size()));
}

std::optional<int> in_position(std::string_view message) {
  if (message.size() != 5 || unsolicited_at_front(message) != message.size()) return std::nullopt;
  return (message[1] - '0') * 10 + message[2] - '0';
}

// ---- values

std::optional<std::int64_t> decode_number(std::string_view text) { return whole_number<std::int64_t>(text); }

std::optional<std::vector<std::int64_t>> decode_numbers(std::string_view text, std::size_t count) {
  std::vector<std::int64_t> all;
  for (;;) {
    const auto colon = text.find(':');
    const auto number = decode_number(text.substr(0, colon));
    if (!number) return std::nullopt;
    all.push_back(*number);
    if (colon == text.npos) break;
    text.remove_prefix(colon + 1);
    if (text.empty()) break;  // some print a colon behind the last field too
  }
  if (all.size() < count) return std::nullopt;
  return all;
}

std::optional<std::int64_t> decode_value(const ParamInfo& info, std::string_view text) {
  if (!info.prefix.empty()) {
    if (!text.starts_with(info.prefix)) return std::nullopt;
    return decode_number(text.substr(info.prefix.size()));
  }
  if (info.decimals == 0) return decode_number(text);
  const auto point = text.find('.');
  const auto whole = decode_number(text.substr(0, point));
  constexpr std::int64_t largest = 1'000'000'000'000;  // no controller's number comes near it
  if (!whole || *whole < 0 || *whole > largest) return std::nullopt;
  std::string_view fraction = point == text.npos ? std::string_view() : text.substr(point + 1);
  std::int64_t value = *whole;
  for (int i = 0; i < info.decimals; ++i) {
    const bool more = !fraction.empty();
    if (more && !is_digit(fraction.front())) return std::nullopt;
    value = value * 10 + (more ? fraction.front() - '0' : 0);
    if (more) fraction.remove_prefix(1);
  }
  return value;
}

std::string encode_value(const ParamInfo& info, std::int64_t value) {
  if (!info.prefix.empty()) return fmt::format("{}{:0{}}", info.prefix, value, info.digits);
  if (info.decimals == 0) return fmt::format("{}", value);
  std::int64_t unit = 1;
  for (int i = 0; i < info.decimals; ++i) unit *= 10;
  return fmt::format("{}.{:0{}}", value / unit, value % unit, info.decimals);
}

// ---- commands

std::string fill(const Forms& forms, std::string_view form, int axis, Sign sign, std::int64_t number) {
  std::string text;
  for (const char c : form) {
    if (c == 'a')
      text += letter(*forms.model, axis);
    else if (c == 's')
      text += hw::letter(sign);
    else if (c == 'n')
      text += std::to_string(number);
    else
      text += c;
  }
  return text;
}

std::string set_command(std::string_view name, std::int64_t value) {
  return fmt::format("{}={}", name, value);
}

std::string set_command(const ParamInfo& info, std::int64_t value) {
  return fmt::format("{}={}", info.mnemonic, encode_value(info, value));
}

std::string move_command(const Forms& forms, const std::vector<AxisValue>& targets) {
  std::string text;
  for (const AxisValue& t : targets) text += fmt::format("{}{}", letter(*forms.model, t.axis), t.value);
  return text;
}

bool may_move(const Forms& forms, std::string_view text) {
  if (text.empty()) return false;
  const auto& letters = forms.model->axis_letters;
  const char after = text.size() > 1 ? text[1] : '\0';
  const bool number_follows = is_digit(after) || after == '-' || after == '+' || after == ' ';
  if (letters.find(text[0]) != letters.npos && number_follows) return true;
  for (const std::string_view head : {"H", "J", "L", "Z", "T", "I", "CIR", "ARC", "GS", "SR", "SSPD"}) {
    if (!text.starts_with(head)) continue;
    const std::string_view rest = text.substr(head.size());
    const bool sets_or_asks = rest.find('=') != rest.npos && head != "SR" && head != "SSPD" && head != "J";
    if (sets_or_asks) continue;
    const bool axis_or_sign = !rest.empty() && (is_digit(rest[0]) || rest[0] == '+' || rest[0] == '-' ||
                                                letters.find(rest[0]) != letters.npos || rest[0] == 'P' ||
                                                rest[0] == 'N' || rest.starts_with("E="));
    const bool signed_word = rest.ends_with('+') || rest.ends_with('-');
    if (axis_or_sign || signed_word) return true;
  }
  return false;
}

bool may_set_counter(std::string_view text) {
  if (text.starts_with("GS")) return true;
  if (text.starts_with("SR")) return !ends_program(text);
  const std::string_view name = text.substr(0, text.find('='));
  if (name.size() == text.size()) return false;
  const bool counter = name.size() == 2 && (name[0] == 'P' || name[0] == 'E');
  return (counter && decode_number(text.substr(name.size() + 1)).value_or(0) == 0) || name == "JE";
}

bool may_set_target(std::string_view text) {
  if (text.starts_with("CLR") || ends_motion(text)) return true;
  const std::string_view name = text.substr(0, text.find('='));
  return name.size() != text.size() && name.size() <= 3 && name.starts_with("SL");
}

bool may_switch_motor(std::string_view text) {
  const std::string_view name = text.substr(0, text.find('='));
  return name.size() != text.size() && name.starts_with("EO") && name.size() <= 3;  // not EOBOOT
}

namespace {

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(' ');
  return begin == text.npos ? std::string_view() : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

}  // namespace

std::string bare_text(std::string_view text) {
  const auto equals = text.find('=');
  if (equals == text.npos) return std::string(trimmed(text));
  return fmt::format("{}={}", trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1)));
}

std::string command_in(std::string_view bytes) { return bare_text(text_of(bytes)); }

bool ends_motion(std::string_view text) {
  const std::string_view word = trimmed(text);
  return word.starts_with("STOP") || word.starts_with("ABORT");
}

std::optional<int> thread_named_in(std::string_view text) {
  const std::string clean = bare_text(text);
  const auto equals = clean.find('=');
  if (!clean.starts_with("SR") || equals == clean.npos || equals < 3 || !is_digit(clean[2]))
    return std::nullopt;
  return whole_number<int>(std::string_view(clean).substr(2, equals - 2));
}

bool ends_program(std::string_view text) {
  if (!thread_named_in(text)) return false;
  const std::string clean = bare_text(text);
  std::string_view value = std::string_view(clean).substr(clean.find('=') + 1);
  if (value.starts_with('+') && value.size() > 1 && is_digit(value[1])) value.remove_prefix(1);
  return decode_number(value) == 0;
}

bool runs_program(std::string_view text) {
  return text.starts_with("GS") || (thread_named_in(text) && !ends_program(text));
}

bool has_bit(std::int64_t word, int bit) { return bit != no_bit && (word >> bit & 1) != 0; }

// Decision AMB-133: accelerating, constant and decelerating are the lowest three bits of both tables.
bool reports_motion(std::int64_t word) { return (word & 7) != 0; }

// ---- refusals

namespace {

struct Explanation {
  Refusal why;
  const char* words;
};
constexpr Explanation explanations[] = {
    {Refusal::bad_index, "its number is outside the allowed range"},
    {Refusal::limit_error, "a limit error is latched: clear the errors, then move away from the switch"},
    {Refusal::alarm,
     "the alarm input of an axis is active, or its error is latched: look at the driver, then clear the "
     "errors"},
    {Refusal::loop_error,
     "StepNLoop has an error: find out why the axis did not follow, then clear the errors"},
    {Refusal::moving,
     "an axis of the command is moving, or under the joystick: stop it, or wait until it is at rest"},
    {Refusal::incremental, "arcs and circles need absolute mode"},
    {Refusal::not_targeted, "no move to a target is under way"},
    {Refusal::no_subroutine, "the stored program has no subroutine of that number"},
    {Refusal::timer_runs, "the timer has not run down to 0 yet"},
    {Refusal::buffer_full, "all 36 places of the buffer are taken"},
    {Refusal::speed,
     "the speed can be changed only while the axis moves, with straight ramps and a window chosen before"},
    {Refusal::speed_s_curve, "the speed cannot be changed while S-curves are on"},
    {Refusal::speed_window, "the old or the new speed lies outside the chosen window"},
    {Refusal::needs_rs485, "Modbus needs the RS-485 line: set the kind of line first"},
};

}  // namespace

std::string explain_refusal(const Model& model, std::string_view reply) {
  // The models that have one word for several reasons print it for the first of them.
  const bool shared_word =
      model.refusal(Refusal::limit_error) == reply && model.refusal(Refusal::loop_error) == reply;
  if (shared_word)
    return "a limit error or a StepNLoop error is latched: find out why, then clear the errors";
  for (const Explanation& e : explanations)
    if (model.refusal(e.why) == reply) return e.words;
  return "the command is unknown, its value is not allowed, or it is not possible now";
}

}  // namespace hw::arcus
