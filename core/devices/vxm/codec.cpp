#include "core/devices/vxm/codec.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/base/number_text.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

constexpr std::int64_t all_but_program_0 = -5;

std::optional<std::int64_t> signed_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  return whole_number<std::int64_t>(text);
}

std::optional<std::string_view> body_of(std::string_view reply) {
  if (!reply.ends_with('\r')) return std::nullopt;
  reply.remove_suffix(1);
  return reply;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = text.find('\r');
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    while (!text.empty() && text.front() == '\n') text.remove_prefix(1);
  }
  return lines;
}

bool bare_mnemonic(std::string_view mnemonic) {
  return mnemonic == "Bx" || mnemonic == "O" || mnemonic == "PMA";
}
std::string_view wire_name(std::string_view mnemonic) { return mnemonic == "Bx" ? "B" : mnemonic; }

}  // namespace

std::string index_by(int motor, Steps distance) { return fmt::format("I{}M{}\r", motor, distance.value); }
std::string index_to(int motor, Steps position) { return fmt::format("IA{}M{}\r", motor, position.value); }
std::string home(int motor, Sign sign) {
  return fmt::format("I{}M{}0\r", motor, sign == Sign::minus ? "-" : "");
}
std::string zero_here(int motor) { return fmt::format("IA{}M-0\r", motor); }
std::string speed(int motor, int steps_per_second) {
  return fmt::format("S{}M{}\r", motor, steps_per_second);
}
std::string acceleration(int motor, int code) { return fmt::format("A{}M{}\r", motor, code); }
std::string index_pair(int slave_motor, Steps slave_distance, int motor, Steps distance) {
  return fmt::format("(I{}M{},I{}M{},)", slave_motor, slave_distance.value, motor, distance.value);
}
std::string output(int number, bool on) {
  constexpr int off_commands[] = {4, 14, 16, 18};  // U4/U5, U14/U15, U16/U17, U18/U19
  return fmt::format("U{}\r", off_commands[std::clamp(number, 1, 4) - 1] + (on ? 1 : 0));
}
std::string select_program(int slot) { return fmt::format("PM{}\r", slot); }
std::string empty_program(int slot) { return fmt::format("PM-{}\r", slot); }
std::string ask_position(int motor) { return std::string(1, "XYZT"[std::clamp(motor, 1, 4) - 1]); }

std::string set_param(std::string_view mnemonic, std::int64_t value) {
  if (mnemonic == "PMA" && value == all_but_program_0) return "PMA-0\r";
  return fmt::format("{}{}{}\r", bare_mnemonic(mnemonic) ? "" : "set", wire_name(mnemonic), value);
}
std::string get_param(std::string_view mnemonic) {
  // get... acts on its last letter; B, O and PMA could continue and need an ender.
  return bare_mnemonic(mnemonic) ? fmt::format("{}\r", wire_name(mnemonic)) : fmt::format("get{}", mnemonic);
}

std::optional<Steps> decode_position(std::string_view reply) {
  const auto text = body_of(reply);
  // The manual's sample for motor 3 has six digits, all others seven.
  if (!text || text->size() < 7 || text->size() > 8) return std::nullopt;
  if (text->front() != '+' && text->front() != '-') return std::nullopt;
  if (!std::all_of(text->begin() + 1, text->end(), is_digit)) return std::nullopt;
  const auto value = signed_number(*text);
  if (!value || *value < position_min || *value > position_max) return std::nullopt;
  return Steps{*value};
}

std::optional<std::int64_t> decode_number(std::string_view reply) {
  const auto text = body_of(reply);
  if (!text) return std::nullopt;
  if (*text == "-0") return all_but_program_0;
  return signed_number(*text);
}

std::optional<char> decode_state(std::string_view reply) {
  if (reply.size() != 1) return std::nullopt;
  for (const char state : {busy, ready, jog_idle, jog_moving})
    if (reply[0] == state) return state;
  return std::nullopt;
}

std::optional<std::string> decode_text_line(std::string_view reply) {
  const auto text = body_of(reply);
  if (!text || text->empty()) return std::nullopt;
  const auto plain = [](char c) { return is_digit(c) || c == '.' || c == '-'; };
  if (!std::all_of(text->begin(), text->end(), plain)) return std::nullopt;
  return std::string(*text);
}

std::optional<Listing> decode_listing(std::string_view reply) {
  if (!reply.ends_with('\r')) return std::nullopt;
  const auto is_head = [](std::string_view line) {
    return line.starts_with("PM") && line.find(" M") != line.npos;
  };
  const auto lines = lines_of(reply);
  if (std::count_if(lines.begin(), lines.end(), is_head) != 1 || !is_head(lines.front())) return std::nullopt;
  const std::string_view head = lines.front();
  const auto gap = head.find(" M");
  const auto slot = signed_number(head.substr(2, gap - 2));
  const auto free = signed_number(head.substr(gap + 2));
  if (!slot || *slot < 0 || *slot >= program_count || !free || *free < 0 || *free > program_bytes)
    return std::nullopt;
  Listing listing;
  listing.slot = static_cast<int>(*slot);
  listing.free_bytes = static_cast<int>(*free);
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (!lines[i].empty()) listing.commands.emplace_back(lines[i]);
  return listing;
}

std::optional<Digitized> decode_digitized(std::string_view reply, int motors) {
  const auto lines = lines_of(reply);
  if (lines.size() < 2 || static_cast<int>(lines.size()) > motors) return std::nullopt;
  Digitized all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].empty() || lines[i].front() != "XYZT"[i]) return std::nullopt;
    const auto position = decode_position(std::string(lines[i].substr(1)) + '\r');
    if (!position) return std::nullopt;
    all.positions.push_back(*position);
  }
  return all;
}

bool reports_error(std::string_view reply) {
  while (!reply.empty()) {
    const std::size_t end = reply.find_first_of("\r\n");
    const std::string_view line = reply.substr(0, end);
    if (line.size() == 2 && (line[0] == error_mark || line[0] == error_mark_barred) &&
        std::string_view("BMLJCN").find(line[1]) != std::string_view::npos)
      return true;
    reply.remove_prefix(end == std::string_view::npos ? reply.size() : end + 1);
  }
  return false;
}

bool limit_active(unsigned char byte, int axis, Sign sign) {
  return !(byte >> limit_bit(axis + 1, sign == Sign::plus) & 1);
}

std::uint32_t inputs_of(unsigned char byte) { return (byte >> 4 & 0x0Fu) | (byte & 0x0Fu) << 4; }

Message next_message(std::string_view bytes) {
  Message m;
  const auto is = [&](Message::Kind kind, std::size_t length) { return m.kind = kind, m.length = length, m; };
  if (bytes.empty()) return m;
  switch (bytes.front()) {
    case prompt: return is(Message::Kind::prompt, 1);
    case over_travel: return is(Message::Kind::limit, 1);
    case waits_for_go: return is(Message::Kind::waits, 1);
    case index_passed: return is(Message::Kind::passed, 1);
    case '\r': return is(Message::Kind::end, 1);
    case error_mark:
    case error_mark_barred:
      if (bytes.size() < 2) return m;
      if (std::string_view("BMLJCNS").find(bytes[1]) == std::string_view::npos)
        return is(Message::Kind::unknown, 1);
      m.letter = bytes[1];
      return is(Message::Kind::error, 2);
    case held: {
      constexpr std::size_t longest_command = 48;  // a pair of indexes with all their digits
      constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-,()";
      const auto end = bytes.find_first_not_of(letters, 1);
      if (end == bytes.npos && bytes.size() <= longest_command) return m;
      if (end == bytes.npos || end > longest_command || bytes[end] != '\r')
        return is(Message::Kind::unknown, 1);
      m.text = bytes.substr(1, end - 1);
      return is(Message::Kind::held, end + 1);
    }
    default: return is(Message::Kind::unknown, 1);
  }
}

static std::size_t before(std::string_view received, std::string_view reply_starts) {
  if (received.empty() || reply_starts.find(received.front()) != std::string_view::npos) return 0;
  const Message m = next_message(received);
  return m.kind == Message::Kind::unfinished ? std::string_view::npos : m.length;
}
std::size_t before_number(std::string_view received) { return before(received, "+-0123456789"); }
std::size_t before_state(std::string_view received) { return before(received, "BRJb"); }
std::size_t before_prompt(std::string_view received) { return before(received, "^"); }
std::size_t before_listing(std::string_view received) { return before(received, "P"); }

bool could_be_message(char byte) {
  return next_message(std::string_view(&byte, 1)).kind != Message::Kind::unknown;
}

ErrorWords explain_error(char letter) {
  const char* recover =
      "Press Stop: the console then sends K, which clears the error and switches the outputs off.";
  switch (letter) {
    case error_bus:
      return {
          "The controller reports EB: it met a command for motor 3 or 4, but no second controller answers on "
          "the VXM bus. It has restarted.",
          "Check that the Slave is switched on and its cable plugged, and that this controller is set to be "
          "the "
          "Master (DM bit 6).",
          false, true};
    case error_memory:
      return {
          "The controller reports EM: the program memory is full, and the last command was not stored. It "
          "accepts nothing until it receives K.",
          std::string(recover) + " Then shorten the program.", true, false};
    case error_loops:
      return {
          "The controller reports EL: more than 10 loops were nested in one run. It accepts nothing until it "
          "receives K.",
          std::string(recover) + " Then use fewer loops inside each other.", true, false};
    case error_jumps:
      return {
          "The controller reports EJ: more than 4 JM jumps were nested in one run. It accepts nothing until "
          "it receives K.",
          std::string(recover) + " Then let fewer programs call each other.", true, false};
    case error_nonstop:
      return {
          "The controller reports EC: nonstop indexing has no U9, U91, U92 or U99 at its end, or it contains "
          "another motor. The controller accepts nothing until it receives K.",
          std::string(recover) + " Then correct the part of the program that begins with U7, U77 or U8.",
          true, false};
    case error_erased:
      return {
          "The controller reports EN: its memory was erased. Programs, settings and motor types have their "
          "factory values again, and it has restarted.",
          "Choose the motor types in Setup before the next move.", false, true};
    case error_stopped:
      return {"The controller reports ES: the Stop button or input 4 ended the program.",
              "Release it, and run again when it is safe.", false, false};
    default: break;
  }
  return {fmt::format("The controller reports an error that the manual does not list: E{}.", letter), "",
          false, false};
}

std::string printable(std::string_view bytes) {
  std::string all;
  for (const char c : bytes)
    all += c >= ' ' && c < 127 ? std::string(1, c)
           : c == '\r'         ? "<cr>"
                               : fmt::format("<{:02X}>", static_cast<unsigned char>(c));
  return all;
}

}  // namespace hw::vxm
