#pragma once
// Which controllers answer on which ports. A question here must move nothing whatever hears it: each type's
// probe, a lone `V` first, at each of its rates; the next type's only where all rates stayed silent. So
// whatever would take an addressed question for commands has answered, and been left alone, before one goes
// out.
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
  unusable,  ///< not there, no serial port, no hardware
  silent,    ///< open, asked, nothing came back
  garbled,   ///< bytes came that make no sense
};

struct PortReport {
  SerialPort port;
  PortFinding finding = PortFinding::silent;
  std::string model, name;  ///< answers: "vxm", "Velmex VXM"
  std::string id;           ///< answers or garbled, where several share a line: which was asked, "07"
  int baud = 0;             ///< answers, garbled: the rate
  Duration round_trip{};    ///< answers: from the question to the last byte of the answer
  std::string reply;        ///< answers, garbled: as it came
  bool echo = false;        ///< answers: the question came back in front of the answer
  std::vector<int> asked;   ///< the rates that were tried
  Fault fault;              ///< busy, not_permitted, unusable

  /// What opens it: "vxm@serial:/dev/ttyUSB0,baud=9600"; empty unless it answers.
  [[nodiscard]] std::string address() const;
  /// What was found and, where something is amiss, what to do.
  [[nodiscard]] std::string sentence() const;
};

/// Asks one port: opens it, leaves it closed. Of controllers that share a line the one with the usual id.
Task<PortReport> probe_port(Scheduler& scheduler, SerialPort port);
/// One after the other, in their order. `found` (may be empty) hears of each as soon as it is known.
Task<std::vector<PortReport>> scan_ports(Scheduler& scheduler, std::vector<SerialPort> ports,
                                         std::function<void(const PortReport&)> found);

/// Every device on lines that several can share: each id at each rate.
struct DeviceSearch {
  std::vector<SerialPort> ports;
  std::vector<int> bauds;  ///< empty: those of the catalogs
  int first_id = 0, last_id = 99;
};
struct SearchProgress {
  std::string port, id;  ///< asked next
  int baud = 0;
  int asked = 0, of = 0;  ///< questions; what stands before the first id is not counted
};
/// Answers those that were found. `go_on` is asked before each question and ends the search by false; `found`
/// hears of each device at once, of each port that could not be asked, and of each id to which something came
/// that makes no sense. Both may be empty.
Task<std::vector<PortReport>> search_devices(Scheduler& scheduler, DeviceSearch search,
                                             std::function<bool(const SearchProgress&)> go_on,
                                             std::function<void(const PortReport&)> found);

}  // namespace hw
