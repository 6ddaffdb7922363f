#include "transports/scan.h"

#include <cctype>

#include <fmt/format.h>

#include "core/device/registry.h"
#include "transports/byte_line.h"
#include "transports/serial.h"

namespace hw {
namespace {

constexpr Duration patience =
    Millis(150);  // for the first byte: a controller that is busy, an adapter that waits
constexpr Duration quiet = Millis(25);  // an answer has ended; an adapter may hand it over in pieces

struct Heard final : Stream::Listener {
  explicit Heard(Scheduler& s) : scheduler(s), news(s) {}
  Scheduler& scheduler;
  Event news;
  std::string bytes;
  Instant last{};
  bool closed = false;
  void bytes_arrived(std::string_view more) override {
    bytes += more;
    last = scheduler.now();
    news.notify();
  }
  void stream_closed(const Fault&) override {
    closed = true;
    news.notify();
  }
};

// Waits for an answer and its end, not for ever: something may talk by itself.
Task<> hear_out(Scheduler& scheduler, Heard& heard, int baud) {
  const Instant at_most = scheduler.now() + Millis(400);
  Instant until = scheduler.now() + patience + 2 * byte_time(baud);
  while (!heard.closed && until < at_most) {
    const bool more = co_await heard.news.wait_until(until);
    if (!more) break;
    until = scheduler.now() + quiet + 2 * byte_time(baud);
  }
}

Task<bool> ask_at(Scheduler& scheduler, Stream& stream, const DeviceType& type, int baud,
                  PortReport& report) {
  if (!stream.set_rate(baud)) co_return false;
  report.asked.push_back(baud);
  Heard heard(scheduler);
  stream.listen(&heard);
  const Instant began = scheduler.now();
  stream.send(type.probe);
  co_await hear_out(scheduler, heard, baud);
  stream.listen(nullptr);
  if (heard.bytes.empty()) co_return false;
  report.reply = heard.bytes;
  report.baud = baud;
  report.finding = PortFinding::garbled;
  if (!type.recognises(heard.bytes)) co_return false;
  report.finding = PortFinding::answers;
  report.model = type.model;
  report.round_trip = heard.last - began;
  report.echo = heard.bytes.starts_with(type.probe);
  co_return true;
}

Task<bool> ask_as(Scheduler& scheduler, Stream& stream, const DeviceType& type, PortReport& report) {
  const DeviceOptions usual;
  const auto catalog = type.make_catalog(usual);
  if (!catalog || type.probe.empty()) co_return false;
  for (const int baud : catalog->can.bauds) {
    if (!co_await ask_at(scheduler, stream, type, baud, report)) continue;
    report.name = catalog->name;
    co_return true;
  }
  co_return false;
}

PortFinding finding_of(PortRefusal refusal) {
  switch (refusal) {
    case PortRefusal::busy: return PortFinding::busy;
    case PortRefusal::not_permitted: return PortFinding::not_permitted;
    default: return PortFinding::unusable;
  }
}

std::string printable(std::string_view bytes) {
  std::string text;
  for (const char c : bytes.substr(0, 8))
    text += std::isgraph(static_cast<unsigned char>(c))
                ? std::string(1, c)
                : fmt::format("<{:02X}>", static_cast<unsigned char>(c));
  return text + (bytes.size() > 8 ? " ..." : "");
}

}  // namespace

std::string PortReport::address() const {
  return finding == PortFinding::answers ? fmt::format("{}@serial:{},baud={}", model, port.path, baud)
                                         : std::string();
}

std::string PortReport::sentence() const {
  switch (finding) {
    case PortFinding::answers:
      return fmt::format("{} answers at {} baud in {:.0f} ms{}.", name, baud, seconds(round_trip) * 1e3,
                         echo ? "; its echo is on" : "");
    case PortFinding::silent:
      return fmt::format(
          "Nothing answers at {} baud. Is the controller switched on and connected to this port?",
          fmt::join(asked, ", "));
    case PortFinding::garbled:
      return fmt::format(
          "At {} baud something answers that makes no sense here: {}. Another device, or another rate.", baud,
          printable(reply));
    default: return fault.sentence();
  }
}

Task<PortReport> probe_port(Scheduler& scheduler, SerialPort port) {
  PortReport report;
  report.port = std::move(port);
  PortRefusal refusal = PortRefusal::none;
  const auto stream = open_serial(scheduler, report.port.path, 9600, &refusal);
  if (!stream) {
    report.finding = finding_of(refusal);
    report.fault = stream.error();
    co_return report;
  }
  for (const DeviceType& type : device_types()) {
    const bool answered = co_await ask_as(scheduler, **stream, type, report);
    if (answered || report.finding == PortFinding::garbled) break;
  }
  co_return report;
}

Task<std::vector<PortReport>> scan_ports(Scheduler& scheduler, std::vector<SerialPort> ports,
                                         std::function<void(const PortReport&)> found) {
  std::vector<PortReport> reports;
  for (SerialPort& port : ports) {
    reports.push_back(co_await probe_port(scheduler, std::move(port)));
    if (found) found(reports.back());
  }
  co_return reports;
}

}  // namespace hw
