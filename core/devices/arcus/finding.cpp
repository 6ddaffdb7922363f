#include "core/devices/arcus/finding.h"

#include <optional>

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::arcus {
namespace {

std::string hex_of(std::string_view bytes) {
  std::string all;
  for (const char c : bytes.substr(0, 12))
    all += c > ' ' && c < 127 ? std::string(1, c) : fmt::format("<{:02X}>", static_cast<unsigned char>(c));
  return all + (bytes.size() > 12 ? " ..." : "");
}

constexpr int attempts_at_connect = 4;
constexpr Duration first_patience = Millis(300);
constexpr Duration slow_from = Millis(150);

}  // namespace

// ID gives the product; if a firmware does not know ID, VER shows at least the family. A lost device is asked
// for its name first, so that a late reply is not taken for one of the others on its line.
Task<Result<>> Finding::identify() {
  if (was_lost_) {
    const Instant began = console_.scheduler.now();
    const auto greeted = co_await conversation_.greet(first_patience);
    if (!greeted && greeted.error().kind == FaultKind::lost) co_return fail(greeted.error());
    const bool received = conversation_.is_open() && conversation_.station()->received_at() > began;
    if (!greeted && received) co_return conversation_.two_devices_answer();
    if (!greeted && greeted.error().kind == FaultKind::no_answer) co_return silent();
  }
  auto reply = co_await ask_identity("ID", [this](std::string_view text) {
    return text == console_.model().product || text == console_.forms.other_product;
  });
  if (!reply && reply.error().kind == FaultKind::no_answer) co_return silent();
  if (!reply) co_return fail(reply.error());
  if (reply->text == "ID") co_return echoed();
  if (reply->text == console_.forms.other_product)
    co_return fail(FaultKind::garbled,
                   fmt::format("Device {:02} is a {}, not a {}.", console_.catalog.address, reply->text,
                               console_.model().title),
                   "Nothing more was sent.", "Open it as the other model.");
  const bool known = reply->text == console_.model().product;
  auto version = co_await ask_identity("VER", reply_kinds::is_version);
  if (!version) co_return fail(version.error());
  if (conversation_.line_feeds() > 0) co_return line_feeds_come();
  if (!reply_kinds::is_version(version->text)) co_return garbled(known ? version->text : reply->text);
  co_await conversation_.wait_for_quiet();  // a second device with this address would have spoken by now
  if (conversation_.unexpected() > 0) co_return conversation_.two_devices_answer();
  conversation_.know_product(known);
  console_.snapshot.identity.model = known ? reply->text : hex_of(reply->text);
  console_.snapshot.identity.firmware = version->text;
  if (!known)
    console_.report(Notice::Kind::warning,
                    fmt::format("The controller answers {} to ID, and a {} answers {}. It is used as a {}.",
                                hex_of(reply->text), console_.model().title, console_.model().product,
                                console_.model().title));
  co_return Result<>();
}

// The first reply may belong to the line's previous user or be incomplete; a late one comes from a slow
// controller. A reply or a silence that repeats is accepted.
Task<Result<Reply>> Finding::ask_identity(std::string question, std::function<bool(std::string_view)> is_it) {
  Result<Reply> reply = fail(FaultKind::no_answer, "");
  const Instant began = console_.scheduler.now();
  int silences = 0;
  std::string before;
  for (int attempt = 0; attempt < attempts_at_connect; ++attempt) {
    reply = co_await conversation_.exchange(question, Priority::intent, first_patience, true);
    if (reply && (is_it(reply->text) || reply->text == before)) break;
    if (!reply && !worth_another_try(reply.error())) break;
    silences += !reply && reply.error().kind == FaultKind::no_answer ? 1 : 0;
    const bool received = conversation_.is_open() && conversation_.station()->received_at() > began;
    if ((silences > 1 && !received) || console_.scheduler.now() - began > long_asked) break;
    if (reply) before = reply->text;
    co_await conversation_.wait_for_quiet();
    conversation_.forget_unexpected();
  }
  if (reply) note_how_slow();
  co_return reply;
}

// Records how long the controller needs to reply, beyond the time on the wire.
void Finding::note_how_slow() {
  if (!conversation_.is_open()) return;
  constexpr std::size_t usual_bytes = 24;  // of ID and its answer
  const Station& station = *conversation_.station();
  const Duration waited =
      std::max(station.lateness(), station.statistics().last_round_trip) - station.wire_time(usual_bytes);
  if (waited <= slow_from || std::exchange(slow_reported_, true)) return;
  console_.report(Notice::Kind::warning,
                  fmt::format("The controller takes {:.1f} s to answer. Values are that old when they are "
                              "shown, and a stop is confirmed that late.",
                              seconds(waited)));
}

Task<Result<>> Finding::read_name() {
  auto name = co_await conversation_.ask("DN", Priority::intent);
  if (!name) co_return fail(name.error());
  console_.snapshot.identity.serial = *name;
  conversation_.know_name(*name);
  const bool usb = conversation_.framing() == Framing::message;
  const auto number = number_in_name(console_.model(), *name);
  if (!number && !usb && !std::exchange(name_reported_, true))
    console_.report(
        Notice::Kind::warning,
        fmt::format("Set the device name (DN), Store, and switch the device off and on: it answers at {:02} "
                    "and calls itself {}, where a {} calls itself {}{:02}. On a shared line its late replies "
                    "cannot be distinguished from those of other devices.",
                    console_.catalog.address, hex_of(*name), console_.model().title,
                    console_.model().name_prefix, console_.catalog.address));
  if (number && *number != console_.catalog.address && !usb && !std::exchange(name_reported_, true))
    console_.report(Notice::Kind::info,
                    fmt::format("The device answers at {:02}, but its name is set to {}: it will answer at "
                                "{:02} from the next power-up after Store.",
                                console_.catalog.address, *name, *number));
  co_return Result<>();
}

// ---- reasons why no device was found

tl::unexpected<Fault> Finding::silent() const {
  if (conversation_.framing() == Framing::message)
    return fail(
        FaultKind::no_answer, fmt::format("The {} does not answer on USB.", console_.model().title),
        "Only the query for its name was sent.",
        fmt::format("Check its power supply ({}) and the cable, and close other programs that use it.",
                    console_.forms.supply));
  const int rate = conversation_.is_open() ? conversation_.station()->rate() : 0;
  const std::string elsewhere = rate_advice(rate);
  return fail(
      FaultKind::no_answer,
      fmt::format("No {} answers at address {:02}{}.", console_.model().title, console_.catalog.address,
                  rate > 0 ? fmt::format(", at {} baud", rate) : ""),
      "Only the query for its name was sent.",
      !elsewhere.empty()
          ? elsewhere
          : fmt::format("Check its power supply ({}), {}, the baud rate ({} from the factory), and its "
                        "device name: the last two digits are its address ({}{:02} from the factory).",
                        console_.forms.supply, console_.forms.wires, bauds.front().rate,
                        console_.model().name_prefix, factory_id()));
}

// An address or rate set here and stored takes effect at a power cycle. Empty: no change is known.
std::string Finding::rate_advice(int rate) const {
  const auto stored = [this](std::string_view mnemonic) -> std::optional<std::int64_t> {
    const int index = console_.catalog.find_param(mnemonic);
    if (index < 0) return std::nullopt;
    const ParamState& state = console_.snapshot.params[ix(index)];
    return state.known && state.stored ? std::optional(state.value) : std::nullopt;
  };
  std::string words, options;
  if (const auto name = stored("DN"); name && *name != console_.catalog.address) {
    words = fmt::format("address {:02}", *name);
    options = fmt::format("id={:02}", *name);
  }
  const auto code = stored("DB");
  for (const Baud& b : bauds)
    if (rate > 0 && code == b.code && b.rate != rate) {
      words += fmt::format("{}{} baud", words.empty() ? "" : " and ", b.rate);
      options += fmt::format("{}baud={}", options.empty() ? "" : ",", b.rate);
    }
  if (words.empty()) return {};
  return fmt::format("Open it with {1}: it was given {0}, which takes effect at the next power-up.", words,
                     options);
}

tl::unexpected<Fault> Finding::garbled(std::string_view bytes) const {
  const int rate = conversation_.is_open() ? conversation_.station()->rate() : 0;
  return fail(FaultKind::garbled,
              fmt::format("The device at address {:02} is not a {}: {} came back.", console_.catalog.address,
                          console_.model().title, hex_of(bytes)),
              "Nothing more was sent.",
              fmt::format("Connect one device alone and try again. Another device is there, or it has "
                          "another rate{}, or two devices have the same address.",
                          rate > 0 ? fmt::format(" than {} baud", rate) : ""));
}

tl::unexpected<Fault> Finding::echoed() const {
  return fail(
      FaultKind::garbled, "The line echoes everything that is sent.", "Only the query for its name was sent.",
      "Switch off the echo of the RS-485 adapter; if it has none, its data lines are shorted together.");
}

tl::unexpected<Fault> Finding::line_feeds_come() const {
  return fail(FaultKind::garbled,
              fmt::format("The replies at address {:02} end in CR LF; those of a {} have no LF.",
                          console_.catalog.address, console_.model().title),
              "The reply was not used.",
              "Switch line-end conversion off in the serial server or adapter: it adds the LF.");
}

int Finding::factory_id() const {
  for (const SettingFact& fact : console_.model().settings)
    if (fact.id == Setting::device_name) return static_cast<int>(fact.factory);
  return 0;
}

}  // namespace hw::arcus
