#include <fmt/core.h>

#include "core/device/registry.h"
#include "gui/app/cli.h"
#include "gui/app/output.h"
#include "gui/app/wiring.h"
#include "transports/performax_usb.h"
#include "transports/scan.h"

namespace hw::app {
namespace {

void print_report(const PortReport& report) {
  print_result("{}  {}\n    {}\n", report.port.path, report.port.label(), report.sentence());
  if (const std::string address = report.address(); !address.empty()) print_result("    {}\n", address);
  if (report.finding == PortFinding::silent)
    print_result("    Several devices on one line: handwheel scan {} --ids 00-99\n", report.port.path);
}

void print_usb() {
  for (const PerformaxDevice& device : list_performax()) {
    print_result("usb:{}  {}\n", device.serial, device.product);
    if (!device.permitted) print_result("    This user may not open it. {}\n", udev_advice);
    for (const DeviceType& type : device_types())
      if (const auto catalog = type.make_catalog({}); catalog && catalog->can.usb)
        print_result("    {}@usb:{}\n", type.model, device.serial);
  }
}

bool not_opened(const PortReport& report) {
  return report.finding == PortFinding::busy || report.finding == PortFinding::not_permitted ||
         report.finding == PortFinding::unusable;
}

/// Asks all ports. A named port that cannot be asked fails the job; another port is only reported.
Task<int> scan_all(Scheduler& scheduler, std::vector<SerialPort> ports, bool named) {
  int status = done;
  std::function<void(const PortReport&)> on_report = [&status, named](const PortReport& report) {
    if (named && not_opened(report))
      status = complain(report.sentence());
    else
      print_report(report);
  };
  co_await scan_ports(scheduler, std::move(ports), on_report);
  co_return status;
}

Task<int> search_ids(Scheduler& scheduler, DeviceSearch search) {
  std::function<bool(const SearchProgress&)> go_on = [](const SearchProgress&) { return !output_is_lost(); };
  std::function<void(const PortReport&)> on_report = print_report;
  const int first = search.first_id, last = search.last_id;
  const auto found = co_await search_devices(scheduler, std::move(search), go_on, on_report);
  print_result("{} found among the ids {:02} to {:02}.\n", found.size(), first, last);
  co_return done;
}

// The named ports, even if the system does not list them (a pseudo-terminal); without names all ports.
std::vector<SerialPort> ports_meant(const std::vector<std::string>& named) {
  const std::vector<SerialPort> listed = list_serial_ports();
  if (named.empty()) return listed;
  std::vector<SerialPort> ports;
  for (const std::string& path : named) {
    SerialPort port;
    port.path = path;
    for (const SerialPort& known : listed)
      if (known.path == path) port = known;
    ports.push_back(std::move(port));
  }
  return ports;
}

bool two_digits(std::string_view text) {
  return text.size() == 2 && text.find_first_not_of("0123456789") == text.npos;
}

// Reads "00-99", or "07" for a single id.
Result<> read_ids(const std::string& text, DeviceSearch& search) {
  const std::string_view first = std::string_view(text).substr(0, 2);
  const std::string_view last =
      text.size() == 2 ? first : std::string_view(text).substr(std::min<std::size_t>(3, text.size()));
  const bool dash = text.size() == 2 || (text.size() == 5 && text[2] == '-');
  if (!dash || !two_digits(first) || !two_digits(last) || last < first)
    return fail(FaultKind::text, fmt::format("--ids {} is not a range of device numbers.", text), {},
                "Give the first and the last with two digits each, as --ids 00-99.");
  search.first_id = std::stoi(std::string(first));
  search.last_id = std::stoi(std::string(last));
  return {};
}

Result<DeviceSearch> understand_search(const Given& given) {
  DeviceSearch search;
  search.ports = ports_meant(given.words);
  if (auto read = read_ids(given.one("ids"), search); !read) return fail(read.error());
  for (const std::string& rate : given.all("baud")) {
    if (rate.empty() || rate.size() > 7 || rate.find_first_not_of("0123456789") != rate.npos ||
        std::stoi(rate) == 0)
      return fail(FaultKind::text, fmt::format("--baud {} is not a rate.", rate), {},
                  "Give a whole number, as --baud 9600.");
    search.bauds.push_back(std::stoi(rate));
  }
  return search;
}

}  // namespace

static int scan(const Given& given) {
  if (given.has("baud") && !given.has("ids"))
    return complain("--baud goes with --ids: without ids every rate is tried.", usage);
  if (given.has("ids")) {
    const auto search = understand_search(given);
    if (!search) return complain(search.error(), usage);
    return run_here([&](Scheduler& scheduler) { return search_ids(scheduler, *search); });
  }
  std::vector<SerialPort> ports = ports_meant(given.words);
  if (given.words.empty()) {
    if (ports.empty()) print_result("No serial ports.\n");
    print_usb();
  }
  const bool named = !given.words.empty();
  return run_here([&](Scheduler& scheduler) { return scan_all(scheduler, ports, named); });
}

const Subcommand scan_subcommand{
    "scan",
    "serial ports, USB devices, and which controllers answer on them; moves nothing",
    {{"PORT", "serial ports to ask; none: all that there are", 0, -1}},
    {{"ids", "NN-NN",
      "search each of these numbers on lines that several share, at each rate (default: the usual number "
      "only)"},
     {"baud", "RATE", "with --ids: only at this rate", true}},
    scan,
};

}  // namespace hw::app
