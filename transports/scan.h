#pragma once
// Finds the controllers that answer on the ports. A question must start no motion, whatever device receives
// it. The probe of each type is sent at each of its rates, a lone `V` first. The probe of the next type
// follows only when all rates were silent. So a device that would take an addressed question for commands has
// answered, and is not asked again, before such a question is sent.
#include <functional>
#include <string>
#include <vector>

#include "core/base/asio.h"
#include "core/base/result.h"
#include "core/time/scheduler.h"
#include "transports/ports.h"

namespace hw {

enum class PortFinding {
  answers,  ///< a controller, as `model` at `baud`
  busy,     ///< another program holds the port
  not_permitted,
  unusable,  ///< missing, not a serial port, or without hardware
  silent,    ///< opened and asked; no reply
  garbled,   ///< unintelligible bytes were received
};

struct PortReport {
  SerialPort port;
  PortFinding finding = PortFinding::silent;
  std::string model, name;  ///< answers: "vxm", "Velmex VXM"
  std::string id;           ///< answers or garbled, on a shared line: the id that was asked, "07"
  int baud = 0;             ///< answers, garbled: the rate
  Duration round_trip{};    ///< answers: from the question to the last byte of the reply
  std::string reply;        ///< answers, garbled: as received
  bool echo = false;        ///< answers: the question was echoed before the reply
  std::vector<int> asked;   ///< rates tried
  Fault fault;              ///< busy, not_permitted, unusable

  /// The address: "vxm@serial:/dev/ttyUSB0,baud=9600"; empty unless a controller answers.
  [[nodiscard]] std::string address() const;
  /// The finding and, if there is a problem, the remedy.
  [[nodiscard]] std::string sentence() const;
};

/// Opens a port, asks, and closes it. On a shared line only the controller with the usual id is asked.
Task<PortReport> probe_port(Scheduler& scheduler, SerialPort port);
/// Probes the ports in order. `found` (may be empty) is called with each report at once.
Task<std::vector<PortReport>> scan_ports(Scheduler& scheduler, std::vector<SerialPort> ports,
                                         std::function<void(const PortReport&)> found);

/// A search for all devices on shared lines: each id at each rate.
struct DeviceSearch {
  std::vector<SerialPort> ports;
  std::vector<int> bauds;  ///< empty: the rates of the catalogs
  int first_id = 0, last_id = 99;
};
struct SearchProgress {
  std::string port, id;  ///< asked next
  int baud = 0;
  int asked = 0, of = 0;  ///< number of questions; questions before the first id do not count
};
/// Returns the devices found. `go_on` is called before each question; false ends the search. `found` is
/// called at once for each device, each port that could not be asked, and each id whose reply was
/// unintelligible. Both may be empty.
Task<std::vector<PortReport>> search_devices(Scheduler& scheduler, DeviceSearch search,
                                             std::function<bool(const SearchProgress&)> go_on,
                                             std::function<void(const PortReport&)> found);

}  // namespace hw
