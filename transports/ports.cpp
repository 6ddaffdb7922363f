#include "transports/ports.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "transports/sysfs.h"

namespace hw {
namespace {

namespace fs = std::filesystem;

int hex(const std::string& digits) { return static_cast<int>(std::strtol(digits.c_str(), nullptr, 16)); }

// Whether the port has hardware. The kernel lists all possible 8250 ports; type 0 (PORT_UNKNOWN) means that
// no port was found.
bool is_real(const fs::path& tty) {
  const std::string name = tty.filename();
  std::error_code error;
  if (!fs::exists(tty / "device", error)) return false;
  if (name.starts_with("ttyUSB") || name.starts_with("ttyACM")) return true;
  if (!name.starts_with("ttyS")) return false;
  const std::string type = first_line(tty / "type");
  return !type.empty() && type != "0";
}

void read_usb_names(const fs::path& tty, SerialPort& port) {
  std::error_code error;
  for (fs::path at = fs::canonical(tty / "device", error); !error && at.has_relative_path();
       at = at.parent_path()) {
    if (!fs::exists(at / "idVendor", error)) continue;
    port.vendor_id = hex(first_line(at / "idVendor"));
    port.product_id = hex(first_line(at / "idProduct"));
    port.vendor = first_line(at / "manufacturer");
    port.product = first_line(at / "product");
    port.serial = first_line(at / "serial");
    return;
  }
}

std::map<std::string, std::string> stable_names(const fs::path& dev) {
  std::map<std::string, std::string> names;  // ttyUSB0 -> /dev/serial/by-id/...
  std::error_code error;
  for (const auto& link : fs::directory_iterator(dev / "serial" / "by-id", error)) {
    std::error_code unreadable;
    const fs::path target = fs::read_symlink(link.path(), unreadable);
    if (!unreadable) names.emplace(target.filename(), link.path());
  }
  return names;
}

// ttyUSB2 before ttyUSB10.
bool comes_before(const SerialPort& a, const SerialPort& b) {
  const auto split = [](const std::string& path) {
    const auto digits = path.find_last_not_of("0123456789") + 1;
    return std::pair(path.substr(0, digits), std::strtol(path.c_str() + digits, nullptr, 10));
  };
  const auto kind = [](const std::string& stem) { return stem.ends_with("ttyS") ? 1 : 0; };
  const auto [stem_a, number_a] = split(a.path);
  const auto [stem_b, number_b] = split(b.path);
  return std::tuple(kind(stem_a), stem_a, number_a) < std::tuple(kind(stem_b), stem_b, number_b);
}

}  // namespace

std::string SerialPort::label() const {
  std::string text = vendor;
  if (!product.empty()) text += (text.empty() ? "" : " ") + product;
  if (text.empty()) return vendor_id != 0 ? "USB serial adapter" : "serial port of the computer";
  if (!serial.empty()) text += " (" + serial + ")";
  return text;
}

std::vector<SerialPort> list_serial_ports(const std::string& sys, const std::string& dev) {
  std::vector<SerialPort> ports;
  const auto names = stable_names(dev);
  std::error_code error;
  for (const auto& tty : fs::directory_iterator(fs::path(sys) / "class" / "tty", error)) {
    if (!is_real(tty.path())) continue;
    SerialPort port;
    const std::string name = tty.path().filename();
    port.path = fs::path(dev) / name;
    read_usb_names(tty.path(), port);
    if (const auto found = names.find(name); found != names.end()) port.by_id = found->second;
    ports.push_back(std::move(port));
  }
  std::sort(ports.begin(), ports.end(), comes_before);
  return ports;
}

}  // namespace hw
