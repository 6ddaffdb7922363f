#include "core/devices/arcus/emulator_arcus.h"

#include <algorithm>

#include "core/base/number_text.h"

namespace hw::arcus {
namespace {

constexpr std::size_t longest_line = 256;
constexpr std::size_t transfer = 64;  // bytes of a USB transfer

}  // namespace

ArcusEmulator::ArcusEmulator(const Model& model, std::span<const Command> commands,
                             const EmulatorOptions& options)
    : options_(options), commands_(commands), controller_(model) {
  if (options.motor_power) controller_.load_needs_power();
  if (options.id) {
    controller_.flash().settings.set(Setting::device_name, *options.id);
    controller_.power_up();
  }
}

// --- the line ----------------------------------------------------------------------------------------------

void ArcusEmulator::receive(std::string_view bytes) {
  if (!controller_.powered()) return;
  if (options_.usb) return receive_transfer(bytes);
  for (const char c : bytes) {
    if (c == '\n') continue;  // decision AMB-005
    if (c != '\r') {
      if (line_.size() < longest_line)
        line_ += c;
      else
        overlong_ = true;
      continue;
    }
    obey_line(std::exchange(line_, {}));
    overlong_ = false;
  }
}

/// USB: the text up to the first zero; the rest is left over from earlier transfers.
void ArcusEmulator::receive_transfer(std::string_view bytes) {
  const std::string_view text = bytes.substr(0, bytes.find('\0'));
  if (!text.empty()) obey(text.substr(0, text.find_first_of("\r\n")), true);
}

void ArcusEmulator::obey_line(std::string_view line) {
  constexpr std::size_t prefix = 3;  // @NN
  if (line.size() >= prefix && line[0] == '@' && is_digit(line[1]) && is_digit(line[2])) {
    const int address = (line[1] - '0') * 10 + (line[2] - '0');
    const bool everyone = address == controller_.model().broadcast;
    if (address != controller_.address() && !everyone) return;
    obey(line.substr(prefix), !everyone);
  } else if (options_.unaddressed) {
    obey(line, true);
  }
}

void ArcusEmulator::obey(std::string_view command, bool answers) {
  if (command.empty()) return;
  const bool timed_out = controller_.timed_out();
  // Only the beginning of an overlong text is kept: it is refused in any case.
  const std::string reply = overlong_ ? "?" + std::string(command) : answer(controller_, commands_, command);
  controller_.command_answered(timed_out);
  if (answers && options_.usb) {
    std::string block = reply.substr(0, transfer - 1);
    block.resize(transfer, '\0');
    out_ += block;
  } else if (answers) {
    if (controller_.prefixes_replies()) out_ += "#" + address_text();
    out_ += reply;
    out_ += options_.reply_cr ? '\r' : controller_.model().reply_end;
  }
  after();
}

std::string ArcusEmulator::address_text() const {
  const int n = controller_.address();
  return {static_cast<char>('0' + n / 10), static_cast<char>('0' + n % 10)};
}

void ArcusEmulator::take_output(std::string& sink) {
  sink += out_;
  out_.clear();
}

// --- time --------------------------------------------------------------------------------------------------

void ArcusEmulator::advance_to(Instant now) {
  int at_once = 0;
  for (;;) {
    const auto next = controller_.next_event();
    if (!next || *next > now) break;
    at_once = *next > controller_.now() ? 0 : at_once + 1;
    if (at_once > most_events_at_once) break;
    controller_.advance(std::max(*next, controller_.now()));
    gather();
  }
  if (now > controller_.now()) controller_.advance(now);
  gather();
}

/// Events that a command or the bench has caused at this instant.
void ArcusEmulator::after() { advance_to(controller_.now()); }

void ArcusEmulator::gather() {
  for (const int axis : controller_.arrivals) {
    (void)axis;
    if (controller_.announces_arrivals()) out_ += "$" + address_text() + "P\r";
  }
  controller_.arrivals.clear();
  auto& pulses = controller_.trigger_pulses;
  if (pulses.size() > pulses_kept + pulses_kept / 2)
    pulses.erase(pulses.begin(), pulses.end() - static_cast<std::ptrdiff_t>(pulses_kept));
}

// --- non-volatile memory -----------------------------------------------------------------------------------

Result<> ArcusEmulator::load_memory(std::string_view text) {
  const std::string title(controller_.model().title);
  Flash before = controller_.flash();
  controller_.flash() = Flash(controller_.model());
  if (options_.id) controller_.flash().settings.set(Setting::device_name, *options_.id);
  int good = 0, number = 0;
  std::string problem;
  while (!text.empty()) {
    ++number;
    const auto end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.empty() || line.front() == '#') continue;
    const std::string why = controller_.load_line(line);
    good += why.empty();
    if (problem.empty() && !why.empty()) problem = "line " + std::to_string(number) + " " + why + ".";
  }
  if (good == 0) {
    controller_.flash() = std::move(before);
    return fail(FaultKind::text,
                "This is not a memory of a " + title + (problem.empty() ? "." : ": " + problem),
                "Nothing was changed.");
  }
  ++memory_loads_;
  if (controller_.powered()) {
    controller_.power_down();
    controller_.power_up();
  }
  after();
  if (problem.empty()) return {};
  return fail(FaultKind::text, "The memory of the " + title + " is damaged: " + problem,
              "The readable part was used; the rest has its factory values.",
              "Check polarities and programs before you run a motor.");
}

// --- options -----------------------------------------------------------------------------------------------

namespace {

tl::unexpected<Fault> bad_option(const std::string& what, const std::string& advice = {}) {
  return fail(FaultKind::text, what, "", advice);
}

}  // namespace

Result<EmulatorOptions> read_options(const Model& model, const std::map<std::string, std::string>& given,
                                     bool has_usb, bool has_reply_cr) {
  const std::string title(model.title);
  EmulatorOptions options;
  for (const auto& [key, value] : given) {
    if (key == "id") {
      const SettingFact& name = *Settings(model).fact(Setting::device_name);
      const auto id = value.size() <= 2 ? parse_integer(value) : std::nullopt;
      if (!id || *id < name.min || *id > name.max)
        return bad_option("id=" + value + ": device numbers of a " + title + " are " +
                          (name.min == 0 ? "00" : "01") + " to 99.");
      options.id = static_cast<int>(*id);
    } else if (key == "unaddressed") {
      if (value != "yes" && value != "no") return bad_option("unaddressed=" + value + ": write yes or no.");
      options.unaddressed = value == "yes";
    } else if (key == "framing" && has_usb) {
      if (value != "usb" && value != "line") return bad_option("framing=" + value + ": write usb or line.");
      options.usb = value == "usb";
    } else if (key == "quirk") {
      for (std::string_view rest = value; !rest.empty();) {
        const auto end = std::min(rest.find('+'), rest.size());
        const std::string_view name = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (name == "motor-power")
          options.motor_power = true;
        else if (name == "reply-cr" && has_reply_cr)
          options.reply_cr = true;
        else
          return bad_option(
              "A " + title + " has no quirk \"" + std::string(name) + "\".",
              has_reply_cr ? "Its quirks are motor-power and reply-cr." : "Its quirk is motor-power.");
      }
    } else if (key == "baud") {
      const bool known = std::any_of(bauds.begin(), bauds.end(), [&rate = value](const Baud& b) {
        return std::to_string(b.rate) == rate;
      });
      if (!known)
        return bad_option("baud=" + value + ": a " + title + " works at " + rates_in_words + " baud.");
    } else {
      return bad_option("The " + title + " emulator has no option \"" + key + "\".");
    }
  }
  return options;
}

}  // namespace hw::arcus
