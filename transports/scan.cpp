#include "transports/scan.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include <fmt/format.h>

#include "core/device/registry.h"
#include "transports/byte_line.h"
#include "transports/serial.h"

namespace hw {
namespace {

constexpr Duration patience = Millis(150);  // for the first byte, with a busy controller or a slow adapter
constexpr Duration quiet = Millis(25);      // silence that ends a reply; an adapter may deliver it in pieces

struct Received final : Stream::Listener {
  explicit Received(Scheduler& s) : scheduler(s), news(s) {}
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

// Waits for a reply and its end. The time is bounded, because a device may send without being asked.
Task<> receive_all(Scheduler& scheduler, Received& received, Duration first_byte, int baud) {
  const Instant at_most = scheduler.now() + Millis(400);
  Instant until = scheduler.now() + first_byte;
  while (!received.closed && until < at_most) {
    const bool more = co_await received.news.wait_until(until);
    if (!more) break;
    until = scheduler.now() + quiet + 2 * byte_time(baud);
  }
}

struct Question {
  std::string text, id;
  int baud;
  Duration patience;
};

// The question to the device with this id.
std::string question_to(std::string_view probe, const std::string& id) {
  std::string text(probe);
  if (const auto digits = text.find("NN"); digits != text.npos) text.replace(digits, 2, id);
  return text;
}

// The type that recognises a reply, among the types with the same probe.
const DeviceType* find_author(std::string_view probe, std::string_view reply) {
  for (const DeviceType& type : device_types())
    if (type.probe == probe && type.recognises && type.recognises(reply)) return &type;
  return nullptr;
}

std::string name_of(const DeviceType& type) {
  const auto catalog = type.make_catalog({});
  return catalog ? catalog->name : std::string(type.model);
}

Task<bool> ask(Scheduler& scheduler, Stream& stream, std::string_view probe, const Question& question,
               PortReport& report) {
  if (stream.rate() != question.baud && !stream.set_rate(question.baud)) co_return false;
  if (report.asked.empty() || report.asked.back() != question.baud) report.asked.push_back(question.baud);
  Received received(scheduler);
  stream.listen(&received);
  const Instant began = scheduler.now();
  stream.send(question.text);
  const Duration patience =
      question.patience + static_cast<int>(question.text.size() + 1) * byte_time(question.baud);
  co_await receive_all(scheduler, received, patience, question.baud);
  stream.listen(nullptr);
  report.echo = received.bytes.starts_with(question.text);
  const std::string_view behind_echo =
      std::string_view(received.bytes).substr(report.echo ? question.text.size() : 0);
  if (behind_echo.empty()) co_return false;
  report.reply = received.bytes;
  report.baud = question.baud;
  report.finding = PortFinding::garbled;
  const DeviceType* author = find_author(probe, behind_echo);
  if (!author) author = find_author(probe, received.bytes);
  if (!author) co_return false;
  report.finding = PortFinding::answers;
  report.model = author->model;
  report.name = name_of(*author);
  report.id = question.id;
  report.round_trip = received.last - began;
  co_return true;
}

Task<bool> ask_as(Scheduler& scheduler, Stream& stream, const DeviceType& type, PortReport& report) {
  const auto catalog = type.make_catalog({});
  if (!catalog || type.probe.empty()) co_return false;
  for (const int baud : catalog->can.bauds) {
    const Question question{question_to(type.probe, catalog->id()), catalog->id(), baud, patience};
    const bool answered = co_await ask(scheduler, stream, type.probe, question, report);
    if (answered) co_return true;
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
  if (finding != PortFinding::answers) return {};
  return fmt::format("{}@serial:{},baud={}{}{}", model, port.path, baud, id.empty() ? "" : ",id=", id);
}

std::string PortReport::sentence() const {
  switch (finding) {
    case PortFinding::answers:
      return fmt::format("{}{}{} answers at {} baud in {:.0f} ms{}.", name, id.empty() ? "" : " with id ", id,
                         baud, seconds(round_trip) * 1e3, echo ? "; its echo is on" : "");
    case PortFinding::silent:
      return fmt::format(
          "Nothing answers at {} baud. Is the controller switched on and connected to this port?",
          fmt::join(std::set<int>(asked.begin(), asked.end()), ", "));
    case PortFinding::garbled:
      if (!id.empty())
        return fmt::format(
            "At {} baud the reply to id {} is not understood: {}. Connect one device alone: two may have the "
            "same id, or the rate may be wrong.",
            baud, id, printable(reply));
      return fmt::format("At {} baud the reply is not understood: {}. Check the model and the rate.", baud,
                         printable(reply));
    default: return fault.sentence();
  }
}

namespace {

Result<std::unique_ptr<Stream>> open_for_probe(Scheduler& scheduler, PortReport& report) {
  PortRefusal refusal = PortRefusal::none;
  auto stream = open_serial(scheduler, report.port.path, 9600, &refusal);
  if (!stream) {
    report.finding = finding_of(refusal);
    report.fault = stream.error();
  }
  return stream;
}

}  // namespace

Task<PortReport> probe_port(Scheduler& scheduler, SerialPort port) {
  PortReport report;
  report.port = std::move(port);
  const auto stream = open_for_probe(scheduler, report);
  if (!stream) co_return report;
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

// ---- the search over ids

namespace {

constexpr Duration patience_of_search = Millis(50);  // addressed devices answer quickly or not at all

// The probes for devices on a shared line, each with the rates of its types.
std::map<std::string_view, std::set<int>> addressed_probes(const std::vector<int>& bauds) {
  std::map<std::string_view, std::set<int>> probes;
  for (const DeviceType& type : device_types()) {
    const auto catalog = type.make_catalog({});
    if (!catalog || !catalog->addressed() || type.probe.empty()) continue;
    const auto& rates = bauds.empty() ? catalog->can.bauds : bauds;
    probes[type.probe].insert(rates.begin(), rates.end());
  }
  return probes;
}

// Asks first for a controller without an address, which might take addressed questions for commands.
Task<bool> line_is_taken(Scheduler& scheduler, Stream& stream, PortReport& report) {
  for (const DeviceType& type : device_types()) {
    const auto catalog = type.make_catalog({});
    if (!catalog || catalog->addressed()) continue;
    const bool answered = co_await ask_as(scheduler, stream, type, report);
    if (answered || report.finding == PortFinding::garbled) co_return true;
  }
  co_return false;
}

class Search {
 public:
  Search(Scheduler& scheduler, DeviceSearch search, std::function<bool(const SearchProgress&)> go_on,
         std::function<void(const PortReport&)> found)
      : scheduler_(scheduler),
        search_(std::move(search)),
        probes_(addressed_probes(search_.bauds)),
        go_on_(std::move(go_on)),
        on_report_(std::move(found)) {
    std::size_t rates = 0;
    for (const auto& [probe, bauds] : probes_) rates += bauds.size();
    const auto ids = static_cast<std::size_t>(std::max(0, search_.last_id - search_.first_id + 1));
    progress_.of = static_cast<int>(search_.ports.size() * rates * ids);
  }

  Task<std::vector<PortReport>> run() {
    for (const SerialPort& port : search_.ports) {
      if (ended_) break;
      const int after = progress_.asked + progress_.of / static_cast<int>(search_.ports.size());
      co_await search_port(port);
      if (!ended_) progress_.asked = after;
    }
    co_return std::move(found_);
  }

 private:
  Task<> search_port(const SerialPort& port) {
    PortReport report;
    report.port = port;
    progress_.port = port.path;
    const auto stream = open_for_probe(scheduler_, report);
    if (!stream) {
      if (on_report_) on_report_(report);
      co_return;
    }
    const bool taken = co_await line_is_taken(scheduler_, **stream, report);
    if (taken) {
      take(report);
      co_return;
    }
    for (const auto& [probe, bauds] : probes_)
      for (const int baud : bauds)
        for (int id = search_.first_id; id <= search_.last_id && !ended_; ++id)
          co_await ask_one(port, **stream, probe, baud, id);
  }

  Task<> ask_one(const SerialPort& port, Stream& stream, std::string_view probe, int baud, int id) {
    progress_.id = fmt::format("{:02}", id);
    progress_.baud = baud;
    if (go_on_ && !go_on_(progress_)) {
      ended_ = true;
      co_return;
    }
    ++progress_.asked;
    PortReport report;
    report.port = port;
    const Question question{question_to(probe, progress_.id), progress_.id, baud, patience_of_search};
    co_await ask(scheduler_, stream, probe, question, report);
    if (report.finding == PortFinding::garbled) report.id = progress_.id;
    if (report.finding != PortFinding::silent) take(report);
  }

  void take(const PortReport& report) {
    if (on_report_) on_report_(report);
    if (report.finding == PortFinding::answers) found_.push_back(report);
  }

  Scheduler& scheduler_;
  const DeviceSearch search_;
  const std::map<std::string_view, std::set<int>> probes_;
  std::function<bool(const SearchProgress&)> go_on_;
  std::function<void(const PortReport&)> on_report_;
  SearchProgress progress_;
  std::vector<PortReport> found_;
  bool ended_ = false;
};

}  // namespace

Task<std::vector<PortReport>> search_devices(Scheduler& scheduler, DeviceSearch search,
                                             std::function<bool(const SearchProgress&)> go_on,
                                             std::function<void(const PortReport&)> found) {
  Search running(scheduler, std::move(search), std::move(go_on), std::move(found));
  co_return co_await running.run();
}

}  // namespace hw
