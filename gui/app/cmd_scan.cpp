#include <cstdio>

#include <fmt/core.h>

#include "core/device/registry.h"
#include "gui/app/cli.h"
#include "gui/app/wiring.h"
#include "transports/performax_usb.h"
#include "transports/scan.h"

namespace hw::app {
namespace {

void print_report(const PortReport& report) {
  fmt::print("{}  {}\n    {}\n", report.port.path, report.port.label(), report.sentence());
  if (const std::string address = report.address(); !address.empty()) fmt::print("    {}\n", address);
  std::fflush(stdout);
}

void print_usb() {
  for (const PerformaxDevice& device : list_performax()) {
    fmt::print("usb:{}  {}\n", device.serial, device.product);
    if (!device.permitted) fmt::print("    This user may not open it. {}\n", udev_advice);
    for (const DeviceType& type : device_types())
      if (const auto catalog = type.make_catalog({}); catalog && catalog->can.usb)
        fmt::print("    {}@usb:{}\n", type.model, device.serial);
  }
}

Task<int> scan_all(Scheduler& scheduler) {
  const std::vector<SerialPort> ports = list_serial_ports();
  if (ports.empty()) fmt::print("No serial ports.\n");
  print_usb();
  std::function<void(const PortReport&)> tell = print_report;
  co_await scan_ports(scheduler, ports, tell);
  co_return done;
}

}  // namespace

static int scan(const Given&) { return run_here(scan_all); }

const Subcommand scan_subcommand{
    "scan", "serial ports, and which controllers answer on them; moves nothing", {}, {}, scan,
};

}  // namespace hw::app
