#pragma once
// Which controllers answer on which ports. A question here must move nothing whatever hears it: each type's
// probe, a lone `V` first, at each of its rates; the next type's only where all rates stayed silent.
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

/// Asks one port: opens it, leaves it closed.
Task<PortReport> probe_port(Scheduler& scheduler, SerialPort port);
/// One after the other, in their order. `found` (may be empty) hears of each as soon as it is known.
Task<std::vector<PortReport>> scan_ports(Scheduler& scheduler, std::vector<SerialPort> ports,
                                         std::function<void(const PortReport&)> found);

}  // namespace hw
