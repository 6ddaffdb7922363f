#pragma once
// Lists the serial ports of this computer, with their USB data.
#include <string>
#include <vector>

namespace hw {

struct SerialPort {
  std::string path;    ///< "/dev/ttyUSB0"
  std::string vendor;  ///< "FTDI"; empty, as the next two, for ports that are not USB
  std::string product, serial;
  int vendor_id = 0, product_id = 0;
  std::string by_id;  ///< "/dev/serial/by-id/usb-FTDI_...", stable when the number changes; may be empty

  /// The name for a list: "FTDI FT232R USB UART (A50285BI)"; "serial port of the computer" without USB.
  [[nodiscard]] std::string label() const;
};

/// ttyUSB*, ttyACM*, and those ttyS* that have hardware, in the order of their numbers. Opens no port.
std::vector<SerialPort> list_serial_ports(const std::string& sys = "/sys", const std::string& dev = "/dev");

}  // namespace hw
