#include "transports/ports.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace hw {
namespace {

namespace fs = std::filesystem;

// A machine's /sys and /dev, as the kernel lays them out.
class Ports : public ::testing::Test {
 protected:
  Ports() { fs::create_directories(sys / "class" / "tty"); }
  ~Ports() override { fs::remove_all(root); }

  void add_tty(const std::string& name, const fs::path& device) {
    const fs::path tty = sys / device / "tty" / name;
    fs::create_directories(tty);
    fs::create_directory_symlink(sys / device, tty / "device");
    fs::create_directory_symlink(tty, sys / "class" / "tty" / name);
  }
  void add_usb(const std::string& name, const std::string& bus, const std::string& serial) {
    const fs::path usb = fs::path("devices/pci0/usb1") / bus;
    fs::create_directories(sys / usb);
    write(usb / "idVendor", "0403");
    write(usb / "idProduct", "6001");
    write(usb / "manufacturer", "FTDI");
    write(usb / "product", "FT232R USB UART");
    if (!serial.empty()) write(usb / "serial", serial);
    add_tty(name, usb / (bus + ":1.0") / name);
  }
  void write(const fs::path& file, const std::string& text) { std::ofstream(sys / file) << text << "\n"; }
  std::vector<SerialPort> list() { return list_serial_ports(sys, dev); }

  fs::path root = fs::temp_directory_path() / ("hw-ports-" + std::to_string(::getpid()));
  fs::path sys = root / "sys", dev = root / "dev";
};

TEST_F(Ports, AUsbAdapterReportsItsNames) {
  add_usb("ttyUSB0", "1-2", "A50285BI");
  fs::create_directories(dev / "serial" / "by-id");
  fs::create_symlink("../../ttyUSB0", dev / "serial" / "by-id" / "usb-FTDI_FT232R_A50285BI-if00-port0");
  const auto ports = list();
  ASSERT_EQ(ports.size(), 1u);
  EXPECT_EQ(ports[0].path, dev / "ttyUSB0");
  EXPECT_EQ(ports[0].vendor_id, 0x0403);
  EXPECT_EQ(ports[0].product_id, 0x6001);
  EXPECT_EQ(ports[0].serial, "A50285BI");
  EXPECT_EQ(ports[0].label(), "FTDI FT232R USB UART (A50285BI)");
  EXPECT_EQ(ports[0].by_id, dev / "serial" / "by-id" / "usb-FTDI_FT232R_A50285BI-if00-port0");
}

TEST_F(Ports, OnlyPortsWithHardwareBehindThem) {
  add_tty("ttyS0", "devices/platform/serial8250");
  write("class/tty/ttyS0/type", "4");
  add_tty("ttyS1", "devices/platform/serial8250");
  write("class/tty/ttyS1/type", "0");
  fs::create_directories(sys / "class" / "tty" / "tty0");
  fs::create_directories(sys / "class" / "tty" / "console");
  const auto ports = list();
  ASSERT_EQ(ports.size(), 1u);
  EXPECT_EQ(ports[0].path, dev / "ttyS0");
  EXPECT_EQ(ports[0].label(), "serial port of the computer");
}

TEST_F(Ports, AdaptersFirstInTheOrderOfTheirNumbers) {
  add_tty("ttyS0", "devices/platform/serial8250");
  write("class/tty/ttyS0/type", "4");
  add_usb("ttyUSB10", "1-3", "");
  add_usb("ttyUSB2", "1-4", "");
  add_usb("ttyACM0", "1-5", "");
  std::vector<std::string> names;
  for (const auto& port : list()) names.push_back(fs::path(port.path).filename());
  EXPECT_EQ(names, (std::vector<std::string>{"ttyACM0", "ttyUSB2", "ttyUSB10", "ttyS0"}));
}

TEST_F(Ports, NothingThere) {
  EXPECT_TRUE(list().empty());
  EXPECT_TRUE(list_serial_ports(root / "no", root / "no").empty());
}

}  // namespace
}  // namespace hw
