#include "core/devices/vxm/explain.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/devices/vxm/catalog.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

std::string times(std::int64_t n) { return fmt::format("loop {} times", n); }
std::string tenths(std::int64_t n) {
  return n % 10 ? fmt::format("{}.{} s", n / 10, n % 10) : fmt::format("{} s", n / 10);
}
std::string pause_length(const TextCommand& c) {
  return c.minus ? fmt::format("{:g} ms", static_cast<double>(c.value) / 10) : tenths(c.value);
}

/// Shorter than the help in the catalog.
struct UserWords {
  int number;
  const char* words;
};
constexpr UserWords user_words[] = {
    {2, "allow jogging by hand during waits"},
    {3, "no jogging by hand during waits"},
    {6, "send W and wait for G"},
    {7, "begin nonstop indexing with pulses on output 2"},
    {8, "begin nonstop indexing, @ at each index end"},
    {13, "wait for a button, jump to program 1 or 2 or go on"},
    {16, "output 3 off"},
    {17, "output 3 on"},
    {18, "output 4 off"},
    {19, "output 4 on"},
    {23, "wait for a button, run program 1 or 2 and return, or go on"},
    {50, "wait for press and release on input 1"},
    {51, "wait for press and release on input 1, output 1 on meanwhile"},
    {77, "begin nonstop indexing"},
    {90, "wait for press and release of Run"},
    {91, "end nonstop indexing, write the ramp as an index"},
    {99, "end nonstop indexing at once"},
};

std::string user_command(std::int64_t number) {
  const bool slave = number >= slave_u_offset;
  std::string_view words = help_of(fmt::format("U{}", number % slave_u_offset));
  for (const UserWords& u : user_words)
    if (u.number == number % slave_u_offset) words = u.words;
  if (words.empty()) return "a U command that the VXM does not have";
  return fmt::format("{}{}", slave ? "on the Slave: " : "", words);
}

std::string stored_command(const TextCommand& c) {
  const int motor = c.motor;
  const char* turns = c.minus ? ", motor 1 reverses each pass" : "";
  switch (c.verb) {
    case Verb::index_by: return fmt::format("motor {} moves by {:+} steps", motor, c.signed_value());
    case Verb::index_to: return fmt::format("motor {} moves to {}", motor, c.signed_value());
    case Verb::zero_here: return fmt::format("the position of motor {} becomes zero", motor);
    case Verb::home: return fmt::format("motor {} runs to its {} limit switch", motor, c.minus ? '-' : '+');
    case Verb::speed:
      return fmt::format("motor {} at {} steps/s{}", motor, c.value, c.full_power ? ", full power" : "");
    case Verb::speed_analog:
      return fmt::format("motor {} at a speed from the analog input, range {}", motor, c.value);
    case Verb::acceleration: return fmt::format("motor {} with acceleration {}", motor, c.value);
    case Verb::loop_forever: return "loop for ever";
    case Verb::marker_set: return "loops return to here";
    case Verb::marker_reset: return "loops return to the beginning";
    case Verb::loop: return times(c.value) + turns;
    case Verb::loop_always: return times(c.value) + turns + ", nothing left out";
    case Verb::loop_reverse:
      return fmt::format("repeat once with {} reversed", c.value == 2 ? "motor 2" : "motors 1 and 2");
    case Verb::jump: return fmt::format("go on with program {}", c.value);
    case Verb::jump_return: return fmt::format("run program {} and return", c.value);
    case Verb::jump_pick: return fmt::format("run program {}, return and undo its absolute moves", c.value);
    case Verb::pause: return "wait " + pause_length(c);
    case Verb::pause_output:
      return c.value == 0 ? std::string("output 1 on for 10 µs") : "output 1 on for " + pause_length(c);
    case Verb::user: return user_command(c.value);
    case Verb::pair_begins: return "start of indexes that run together";
    case Verb::pair_ends: return "end of indexes that run together";
    default: return {};
  }
}

struct LetterWords {
  char letter;
  const char* words;
};
constexpr LetterWords letter_words[] = {
    {'Q', "leave on-line mode"},
    {'K', "stop everything at once, outputs off"},
    {'D', "ramp the moving motor down"},
    {'G', "go on, or go on-line with CR after prompts"},
    {'!', "capture the positions"},
    {'V', "ask for the state"},
    {'Z', "ask where motor 3 is"},
    {'T', "ask where motor 4 is"},
    {'x', "ask for the captured positions of motor 1"},
    {'y', "ask for the captured positions of motor 2"},
    {'M', "ask for free memory"},
    {'?', "ask for the limit switches"},
    {'~', "ask for the inputs"},
    {'$', "ask for the outputs"},
    {'@', "ask for the analog input"},
};

std::string letter_command(char letter) {
  for (const LetterWords& l : letter_words)
    if (l.letter == letter) return l.words;
  return std::string(help_of(std::string_view(&letter, 1)));
}

std::string setup_name(std::string_view name) {
  struct Words {
    std::string_view pattern, words;
  };
  constexpr Words table[] = {
      {"B", "the baud rate number"},
      {"DM", "the controller mode"},
      {"DA", "the joystick dead band"},
      {"D0", "the firmware version"},
      {"D1", "the firmware date"},
      {"D2", "the number of motors"},
      {"I", "the input mode"},
      {"PA", "the pulse width"},
      {"Bx", "the backlash compensation"},
      {"O", "the limit report"},
      {"MmM", "the type of motor {}"},
      {"MAmM", "the type of motor {}, full jog power"},
      {"jmM", "the first jog speed of motor {}"},
      {"JmM", "the second jog speed of motor {}"},
      {"jAmM", "the first joystick range of motor {}"},
      {"JAmM", "the second joystick range of motor {}"},
      {"LmM", "the limit switch mode of motor {}"},
      {"PmM", "the pulse distance of motor {}"},
  };
  std::string pattern(name);
  char motor = '1';
  for (char& c : pattern)
    if (c >= '1' && c <= '9' && name.ends_with('M')) motor = std::exchange(c, 'm');
  for (const Words& w : table)
    if (w.pattern == pattern) {
      std::string words(w.words);
      if (const auto gap = words.find("{}"); gap != words.npos) words.replace(gap, 2, 1, motor);
      return words;
    }
  return std::string(name);
}

std::string word_command(std::string_view word) {
  if (word == "rsm") return "store set-up and programs permanently";
  return std::string(help_of(word));
}

std::string immediate_command(const TextCommand& c) {
  switch (c.verb) {
    case Verb::slave_begins: return "start of commands for the Slave";
    case Verb::slave_ends: return "end of commands for the Slave";
    case Verb::select: return fmt::format("choose program {}", c.value);
    case Verb::empty: return fmt::format("choose program {} and empty it", c.value);
    case Verb::ask_selected: return "ask which program is chosen";
    case Verb::associate:
      if (c.value == pma_off) return "programs of Master and Slave run on their own";
      return fmt::format("couple {}program {} of Master and Slave", c.minus ? "all but " : "", c.value);
    case Verb::ask_associate: return "ask which programs of Master and Slave are coupled";
    case Verb::set:
      if (c.name == "D") return "erase everything: factory state";
      return fmt::format("set {} to {}", setup_name(c.name), c.signed_value());
    case Verb::get: return "ask for " + setup_name(c.name);
    case Verb::letter: return letter_command(c.letter);
    case Verb::word: return word_command(c.name);
    default: return {};
  }
}

std::string explain_sent(std::string_view bytes) {
  std::string all;
  for (const TextCommand& c : read_text(bytes)) all += (all.empty() ? "" : "; ") + explain_command(c);
  if (all.empty() && !bytes.empty()) return "end of a command";
  return all;
}

// ---- received

std::string state_words(char state) {
  switch (state) {
    case busy: return "busy";
    case ready: return "ready";
    case jog_idle: return "Local mode, the jog buttons act";
    default: return "Local mode, a motor is being jogged";
  }
}

std::string operated(unsigned char low_bits, const char* const* names, const char* none) {
  std::string all;
  for (int bit = 0; bit < 8; ++bit)
    if (low_bits >> bit & 1) all += (all.empty() ? "" : ", ") + std::string(names[bit]);
  return all.empty() ? none : all;
}

std::string raw_byte(char question, unsigned char byte) {
  static constexpr const char* limits[] = {"limit 1-", "limit 1+", "limit 2-", "limit 2+",
                                           "limit 3-", "limit 3+", "limit 4-", "limit 4+"};
  static constexpr const char* inputs[] = {"jog 1-", "jog 1+", "jog 2-", "jog 2+",
                                           "In 1",   "In 2",   "In 3",   "In 4"};
  static constexpr const char* outputs[] = {"Out 1", "Out 2", "Out 3", "Out 4",
                                            "bit 4", "bit 5", "bit 6", "bit 7"};
  const auto low = static_cast<unsigned char>(~byte);
  if (question == '?') return "active: " + operated(low, limits, "no limit switch");
  if (question == '~') return "low: " + operated(low, inputs, "no input");
  return "on: " + operated(byte, outputs, "no output");
}

std::string explain_answer(std::string_view reply, const TextCommand& question) {
  const char letter = question.verb == Verb::letter ? question.letter : '\0';
  if (letter == '?' || letter == '~' || letter == '$')
    return reply.size() == 1 ? raw_byte(letter, static_cast<unsigned char>(reply[0])) : std::string();
  if (letter == 'V') {
    const auto state = decode_state(reply);
    return state ? state_words(*state) : std::string();
  }
  if (const auto motor = std::string_view("XYZT").find(letter); letter && motor != std::string_view::npos) {
    const auto position = decode_position(reply);
    return position ? fmt::format("motor {} at {} steps", motor + 1, position->value) : std::string();
  }
  if (letter == '*') {
    const auto position = decode_position(reply);
    return position ? fmt::format("the last ramp down began at {} steps", position->value) : std::string();
  }
  if (question.verb == Verb::word && question.name == "lst") {
    const auto listing = decode_listing(reply);
    if (!listing) return {};
    return fmt::format("program {}: {} commands, {} of {} bytes free", listing->slot,
                       listing->commands.size(), listing->free_bytes, program_bytes);
  }
  if (question.verb == Verb::get && (question.name == "D0" || question.name == "D1")) {
    const auto text = decode_text_line(reply);
    return text ? fmt::format("{} is {}", setup_name(question.name), *text) : std::string();
  }
  const auto number = decode_number(reply);
  if (!number) return {};
  if (letter == 'M')
    return fmt::format("{} of {} bytes free, {} used", *number, program_bytes, program_bytes - *number);
  if (letter == '#') return fmt::format("motor {}", *number);
  if (letter == '@') return fmt::format("analog input at {} of {}", *number, analog_max);
  if (question.verb == Verb::ask_selected) return fmt::format("program {} is chosen", *number);
  if (question.verb == Verb::get) return fmt::format("{} is {}", setup_name(question.name), *number);
  return {};
}

std::string message_words(const Message& m) {
  switch (m.kind) {
    case Message::Kind::prompt: return "ended";
    case Message::Kind::limit: return "a limit switch was hit";
    case Message::Kind::waits: return "the program waits for G";
    case Message::Kind::passed: return "an index of nonstop indexing has ended";
    case Message::Kind::held: return fmt::format("the program holds before {}", m.text);
    case Message::Kind::error: return explain_error(m.letter).what;
    default: return {};
  }
}

std::string explain_messages(std::string_view bytes) {
  std::string all;
  while (!bytes.empty()) {
    const Message m = next_message(bytes);
    if (m.length == 0) break;
    const std::string words = message_words(m);
    if (!words.empty()) all += (all.empty() ? "" : "; ") + words;
    bytes.remove_prefix(m.length);
  }
  return all;
}

}  // namespace

std::string explain_command(const TextCommand& c) {
  switch (c.flaw) {
    case Flaw::unknown: return fmt::format("not a command of the VXM: {}", c.name);
    case Flaw::no_value: return "a command without its number: the controller drops it";
    case Flaw::range:
      return fmt::format("{} is out of range ({}): the controller drops it", canonical(c), allowed_values(c));
    case Flaw::open:
    case Flaw::none: break;
  }
  if (c.stored()) return "store: " + stored_command(c);
  return immediate_command(c);
}

std::string explain(std::string_view bytes, Way way, TrafficKind kind, std::string_view asked) {
  if (way == Way::sent) return explain_sent(bytes);
  if (kind == TrafficKind::unparsed) return "not understood";
  if (kind == TrafficKind::unsolicited) return explain_messages(bytes);
  const auto questions = read_text(asked);
  if (questions.empty()) return explain_messages(bytes);
  const std::string answer = explain_answer(bytes, questions.back());
  return answer.empty() ? explain_messages(bytes) : answer;
}

}  // namespace hw::vxm
