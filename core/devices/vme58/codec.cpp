#include "core/devices/vme58/codec.h"

#include <algorithm>
#include <charconv>

#include <fmt/core.h>

#include "core/base/number_text.h"
#include "core/base/split.h"

namespace hw::vme58 {
namespace {

constexpr std::uint16_t cell(std::uint16_t buffer, int index) {
  return static_cast<std::uint16_t>(buffer + 2 * index);
}
bool is_frame(char c) { return c == '\n' || c == '\r'; }

}  // namespace

void append_text(std::vector<BusCycle>& cycles, std::string_view text, int put) {
  int to = put;
  for (const char c : text) {
    cycles.push_back(BusCycle::store(2, cell(at::output_buffer, to), static_cast<unsigned char>(c)));
    to = advanced(to, 1);
  }
  for (int i = put; i != to; i = advanced(i, 1))
    cycles.push_back(BusCycle::read(2, cell(at::output_buffer, i)));
}

void append_reply_reads(std::vector<BusCycle>& cycles, int get, int count) {
  for (int i = 0; i < count; ++i)
    cycles.push_back(BusCycle::read(2, cell(at::input_buffer, advanced(get, i))));
}

std::string reply_text(std::span<const BusCycle> cycles) {
  std::string text;
  for (const BusCycle& cycle : cycles) text += static_cast<char>(cycle.value & 0xFF);
  return text;
}

void append_mail(std::vector<BusCycle>& cycles, std::string_view letters, std::uint8_t control) {
  cycles.push_back(BusCycle::store(2, at::mailbox, static_cast<unsigned char>(letters[0])));
  cycles.push_back(BusCycle::store(2, at::mailbox + 2, static_cast<unsigned char>(letters[1])));
  cycles.push_back(BusCycle::store(1, reg::control, control | control::interrupt_board));
}

// The extra CR of some frames stands before the next reply and is skipped with its head.
std::optional<std::string> take_reply(std::string& received, bool echo) {
  if (echo) {
    const auto frame = received.find("\n\r");
    if (frame == received.npos) {
      const bool half = !received.empty() && received.back() == '\n';
      received = half ? "\n" : "";
      return std::nullopt;
    }
    received.erase(0, frame);
  }
  const auto begin = std::find_if_not(received.begin(), received.end(), is_frame);
  const auto end = std::find_if(begin, received.end(), is_frame);
  if (begin == received.end() || received.end() - end < 2) return std::nullopt;
  std::string text(begin, end);
  received.erase(received.begin(), end + 2);
  return text;
}

namespace {

/// Skips what other hosts skip before the digits: blanks and a plus sign (decision M99).
std::string_view from_its_number(std::string_view text) {
  const auto digits = text.find_first_not_of(' ');
  text.remove_prefix(std::min(digits, text.size()));
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  if (plus) text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

std::optional<std::vector<std::int64_t>> decode_numbers(std::string_view reply) {
  std::vector<std::int64_t> all;
  for (const std::string_view part : split(reply, ',')) {
    const auto number = whole_number<std::int64_t>(from_its_number(part));
    if (!number) return std::nullopt;
    all.push_back(*number);
  }
  return all;
}

std::optional<std::uint32_t> decode_hex(std::string_view reply) {
  reply = from_its_number(reply);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(reply.data(), reply.data() + reply.size(), value, 16);
  if (error != std::errc() || end != reply.data() + reply.size()) return std::nullopt;
  return value;
}

std::optional<AxisFlags> decode_flags(std::string_view letters) {
  constexpr std::string_view on = "PDLH", off = "MNNN";
  if (letters.size() != on.size()) return std::nullopt;
  std::array<bool, 4> is_on{};
  for (std::size_t i = 0; i < on.size(); ++i) {
    is_on[i] = letters[i] == on[i];
    if (!is_on[i] && letters[i] != off[i]) return std::nullopt;
  }
  AxisFlags flags;
  flags.plus = is_on[0], flags.done = is_on[1], flags.limit = is_on[2], flags.home = is_on[3];
  return flags;
}

std::vector<AxisFlags> decode_all_flags(std::string_view reply) {
  std::vector<AxisFlags> all;
  for (const std::string_view part : split(reply, ','))
    if (const auto flags = decode_flags(part)) all.push_back(*flags);
  return all;
}

std::optional<Greeting> decode_greeting(std::string_view reply) {
  const auto version = reply.find(" ver ");
  if (version == reply.npos || version == 0) return std::nullopt;
  Greeting greeting;
  greeting.model = reply.substr(0, version);
  const std::string_view rest = reply.substr(version + 5);
  const auto hyphen = rest.find('-');
  greeting.version = rest.substr(0, hyphen);
  if (hyphen != rest.npos) greeting.variant = rest.substr(hyphen + 1);
  return greeting;
}

bool fits(ReplyForm form, std::string_view reply) {
  const auto count = static_cast<std::size_t>(form.count);
  const auto slip = [](char c) { return c == 'S' || c == 'N'; };
  switch (form.of) {
    case ReplyForm::Of::anything: return true;
    case ReplyForm::Of::numbers: return decode_numbers(reply).has_value();
    case ReplyForm::Of::hex: return decode_hex(reply).has_value();
    case ReplyForm::Of::greeting: return decode_greeting(reply).has_value();
    case ReplyForm::Of::flags: {
      const auto parts = split(reply, ',');
      return parts.size() == count && decode_all_flags(reply).size() == count;
    }
    case ReplyForm::Of::slips: return reply.size() == count && std::all_of(reply.begin(), reply.end(), slip);
    case ReplyForm::Of::loop:
      return reply.size() == 6 && (reply[0] == 'E' || reply[0] == 'D') &&
             (reply[1] == 'E' || reply[1] == 'D');
  }
  return true;
}

void append_axis_reads(std::vector<BusCycle>& cycles, int axis, int count) {
  for (int i = 0; i < count; ++i)
    cycles.push_back(BusCycle::read(4, offset_of(axis, static_cast<AxisValue>(i))));
}

std::string encode_list(std::string_view letters, std::span<const std::optional<std::int64_t>> by_axis) {
  std::string text(letters);
  std::size_t last = 0;
  for (std::size_t i = 0; i < by_axis.size(); ++i)
    if (by_axis[i]) last = i;
  for (std::size_t i = 0; i <= last && i < by_axis.size(); ++i) {
    if (i > 0) text += ',';
    if (by_axis[i]) text += std::to_string(*by_axis[i]);
  }
  return text + ';';
}

std::string_view without_end(std::string_view text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.remove_suffix(1);
  return text;
}

std::string encode_number(std::int64_t value, int decimals) {
  std::int64_t unit = 1;
  for (int i = 0; i < decimals; ++i) unit *= 10;
  const std::int64_t size = value < 0 ? -value : value;
  std::string text = fmt::format("{}{}", value < 0 ? "-" : "", size / unit);
  if (size % unit == 0) return text;
  text += fmt::format(".{:0{}}", size % unit, decimals);
  while (text.back() == '0') text.pop_back();
  return text;
}

}  // namespace hw::vme58
