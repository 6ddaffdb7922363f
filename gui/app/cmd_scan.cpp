#include <cstdio>

#include <fmt/core.h>

#include "gui/app/cli.h"
#include "gui/app/wiring.h"
#include "transports/scan.h"

namespace hw::app {
namespace {

void print_report(const PortReport& report) {
  fmt::print("{}  {}\n    {}\n", report.port.path, report.port.label(), report.sentence());
  if (const std::string address = report.address(); !address.empty()) fmt::print("    {}\n", address);
  std::fflush(stdout);
}

Task<int> scan_all(Scheduler& scheduler) {
  const std::vector<SerialPort> ports = list_serial_ports();
  if (ports.empty()) fmt::print("No serial ports.\n");
  std::function<void(const PortReport&)> tell = print_report;
  co_await scan_ports(scheduler, ports, tell);
  co_return done;
}

}  // namespace

int scan(const Given&) { return run_here(scan_all); }

}  // namespace hw::app
