#include "gui/app/port_watch.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/device/registry.h"
#include "transports/performax_usb.h"

namespace hw::app {
namespace {

using gui::FoundPort;

FoundPort::State state_of(PortFinding finding) {
  switch (finding) {
    case PortFinding::answers: return FoundPort::State::answers;
    case PortFinding::busy: return FoundPort::State::busy;
    case PortFinding::not_permitted: return FoundPort::State::forbidden;
    case PortFinding::silent:
    case PortFinding::garbled: return FoundPort::State::silent;
    case PortFinding::unusable: return FoundPort::State::failed;
  }
  return FoundPort::State::failed;
}

// The four steps from this computer to a controller, as far as the test went.
std::vector<FoundPort::Check> checks_of(const PortReport& r) {
  using CheckResult = FoundPort::Check::Result;
  const bool opened = r.finding == PortFinding::answers || r.finding == PortFinding::silent ||
                      r.finding == PortFinding::garbled;
  const bool returned = r.finding == PortFinding::answers || r.finding == PortFinding::garbled;
  const auto link = [](CheckResult result, std::string what, std::string found) {
    FoundPort::Check check;
    check.result = result, check.what = std::move(what), check.found = std::move(found);
    return check;
  };
  const CheckResult behind = opened ? CheckResult::bad : CheckResult::not_reached;
  return {link(opened ? CheckResult::good : CheckResult::bad, "Port opens",
               opened ? "no other program uses it" : r.sentence()),
          link(opened ? CheckResult::good : CheckResult::not_reached, "Bytes leave",
               opened ? fmt::format("{} speeds", r.asked.size()) : ""),
          link(returned ? CheckResult::good : behind, "Bytes return",
               returned ? "they do"
               : opened ? "none came back"
                        : ""),
          link(r.finding == PortFinding::answers ? CheckResult::good
               : returned                        ? CheckResult::bad
                                                 : CheckResult::not_reached,
               "Reply understood",
               r.finding == PortFinding::answers ? r.name
               : returned                        ? "not understood"
                                                 : "")};
}

Task<> probe_and_report(Scheduler& scheduler, SerialPort port, std::shared_ptr<Ring<PortReport>> reports,
                        std::function<void()> wake) {
  PortReport report = co_await probe_port(scheduler, std::move(port));
  reports->push(std::move(report));
  if (wake) wake();
}

FoundPort usb_port(const PerformaxDevice& device) {
  FoundPort port;
  port.path = "usb:" + device.serial;
  port.hardware = device.product;
  port.usb_serial = device.serial;
  for (const DeviceType& type : device_types())
    if (const auto catalog = type.make_catalog({}); catalog && catalog->can.usb) {
      port.title = catalog->name;
      port.address = fmt::format("{}@{}", type.model, port.path);
    }
  port.state = device.permitted ? FoundPort::State::answers : FoundPort::State::forbidden;
  port.sentence =
      device.permitted ? "is connected by USB." : std::string("This user may not open it. ") + udev_advice;
  return port;
}

// Runs on the io thread while the page is open.
Task<> watch_usb(Scheduler& scheduler, std::shared_ptr<std::atomic<bool>> moved, std::function<void()> wake,
                 std::weak_ptr<void> page) {
  const auto watch = PerformaxWatch::start(scheduler, [moved, wake] {
    moved->store(true);
    if (wake) wake();
  });
  if (!watch) co_return;  // the list is refreshed every two seconds anyway
  while (!page.expired()) co_await scheduler.sleep_for(std::chrono::seconds(1));
}

}  // namespace

void PortWatch::take(PortReport& report) {
  --asking_;
  const auto at = std::find_if(found_.begin(), found_.end(),
                               [&](const FoundPort& p) { return p.path == report.port.path; });
  if (at == found_.end()) return;  // unplugged meanwhile
  at->state = state_of(report.finding);
  at->title = report.name;
  at->sentence = report.sentence();
  at->address = report.address();
  at->checks = checks_of(report);
  at->advice.clear();
  if (report.finding == PortFinding::silent)
    at->advice = {
        "The supply. Is the controller's green lamp lit?",
        "The cable. It must be straight through; try it with RX and TX swapped (a null-modem adapter).",
        "The port. Is the cable plugged into this port? Unplug it and watch which port leaves this list."};
}

const std::vector<FoundPort>& PortWatch::ports() {
  reports_->drain([this](PortReport& report) { take(report); });
  const bool moved = usb_moved_->exchange(false);
  if (watching_ && (moved || scheduler_.now() - listed_at_ >= look_every)) list();
  return found_;
}

void PortWatch::watch(bool on) {
  if (on && !watching_) {
    list();
    page_ = std::make_shared<int>(0);
    asio::co_spawn(scheduler_.executor(), watch_usb(scheduler_, usb_moved_, wake_, page_), asio::detached);
  }
  if (!on) page_.reset();
  watching_ = on;
}

void PortWatch::look() {
  list();
  for (const FoundPort& port : found_)
    if (port.state != FoundPort::State::asking && known_.contains(port.path)) ask(port.path);
}

void PortWatch::list() {
  listed_at_ = scheduler_.now();
  list_serial();
  list_usb();
}

// Asks new ports once, without a request of the user; drops removed ports from the list.
void PortWatch::list_serial() {
  const std::vector<SerialPort> there = list_serial_ports();
  std::erase_if(found_, [&](const FoundPort& p) {
    return known_.contains(p.path) &&
           std::none_of(there.begin(), there.end(), [&](const SerialPort& s) { return s.path == p.path; });
  });
  for (const SerialPort& port : there) {
    known_[port.path] = port;
    if (std::any_of(found_.begin(), found_.end(), [&](const FoundPort& p) { return p.path == port.path; }))
      continue;
    FoundPort fresh;
    fresh.path = port.path;
    fresh.hardware = port.label();
    fresh.usb_serial = port.serial;
    found_.push_back(std::move(fresh));
    ask(port.path);
  }
}

// A USB device is identified by its numbers, so it need not be asked.
void PortWatch::list_usb() {
  std::erase_if(found_, [&](const FoundPort& p) { return !known_.contains(p.path); });
  for (const PerformaxDevice& device : list_performax()) found_.push_back(usb_port(device));
}

void PortWatch::ask(const std::string& path) {
  const auto known = known_.find(path);
  const auto at =
      std::find_if(found_.begin(), found_.end(), [&](const FoundPort& p) { return p.path == path; });
  if (known == known_.end() || at == found_.end()) return;
  at->state = FoundPort::State::asking;
  at->sentence.clear();
  ++asking_;
  asio::co_spawn(scheduler_.executor(), probe_and_report(scheduler_, known->second, reports_, wake_),
                 asio::detached);
}

}  // namespace hw::app
