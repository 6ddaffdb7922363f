#include "transports/scan.h"

#include <filesystem>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include "core/device/registry.h"
#include "tests/transports/ear.h"
#include "tests/transports/pseudo_terminal.h"
#include "tests/transports/toy_emulator.h"
#include "transports/pty_endpoint.h"
#include "transports/serial.h"
#include "transports/serve.h"

namespace hw {
namespace {

using test::run_task;

class Scan : public ::testing::Test {
 protected:
  Scan() {
    std::filesystem::create_directories(folder);
    if (const DeviceType* type = find_device_type("vxm")) bauds = type->make_catalog({})->can.bauds;
  }
  ~Scan() override { std::filesystem::remove_all(folder); }
  void SetUp() override { HW_NEEDS_PSEUDO_TERMINAL(); }

  // The toy answers V as a VXM does.
  std::shared_ptr<EmulatorHost> serve(const std::string& name, int baud) {
    HostOptions options;
    options.byte_times = true;
    auto toy = std::make_unique<test::ToyEmulator>();
    toy->receive(baud == 38400 ? "4" : "9");
    auto host = *EmulatorHost::make(clock, std::move(toy), options);
    host->attach(std::move(*open_pty_endpoint(clock, folder / name, baud)));
    return host;
  }
  SerialPort port(const std::string& path) {
    SerialPort p;
    p.path = path;
    return p;
  }
  PortReport probe(const std::string& path) { return run_task(io, probe_port(clock, port(path))); }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("hw-scan-" + std::to_string(::getpid()));
  IoContext io{1};
  RealScheduler clock{io};
  std::vector<int> bauds;
};

TEST_F(Scan, FindsTheModelAndItsRate) {
  for (const int baud : {9600, 38400}) {
    const auto host = serve("stage", baud);
    const auto report = probe(folder / "stage");
    ASSERT_EQ(report.finding, PortFinding::answers) << report.sentence();
    EXPECT_EQ(report.baud, baud);
    EXPECT_EQ(report.address(),
              "vxm@serial:" + (folder / "stage").string() + ",baud=" + std::to_string(baud));
    EXPECT_NE(report.sentence().find("answers at " + std::to_string(baud)), std::string::npos);
    EXPECT_LT(report.round_trip, Millis(100));
  }
}

TEST_F(Scan, AsksNothingButALoneV) {
  const auto host = serve("stage", 9600);
  probe(folder / "stage");
  EXPECT_EQ(static_cast<const test::ToyEmulator&>(host->bench()->emulator()).received(), "9V");
}

TEST_F(Scan, ASilentPortIsAskedAtEachRate) {
  int master = -1, slave = -1;
  char name[64];
  ASSERT_EQ(::openpty(&master, &slave, name, nullptr, nullptr), 0);
  const auto report = probe(name);
  EXPECT_EQ(report.finding, PortFinding::silent);
  ASSERT_GT(report.asked.size(), bauds.size());  // then those that are asked by an address, at their rates
  EXPECT_EQ(std::vector<int>(report.asked.begin(), report.asked.begin() + std::ssize(bauds)), bauds);
  char asked[256];
  const ssize_t count = ::read(master, asked, sizeof asked);
  ASSERT_GT(count, static_cast<ssize_t>(bauds.size()));
  const std::string text(asked, static_cast<std::size_t>(count));
  EXPECT_TRUE(text.starts_with(std::string(bauds.size(), 'V') + "\r@")) << text;
  EXPECT_EQ(text.find('V', bauds.size()), std::string::npos)
      << "a lone V is asked first and not again: " << text;
  EXPECT_NE(report.sentence().find("switched on"), std::string::npos);
  ::close(master), ::close(slave);
}

// Something that talks all the time, such as a GPS receiver.
TEST_F(Scan, BytesThatMakeNoSenseAreShown) {
  int master = -1, slave = -1;
  char name[64];
  ASSERT_EQ(::openpty(&master, &slave, name, nullptr, nullptr), 0);
  Timer chatter(clock, [&] {
    (void)!::write(master, "$GPRMC\r\n", 8);
    chatter.arm(clock.now() + Millis(10));
  });
  chatter.arm(clock.now() + Millis(10));
  const auto report = probe(name);
  EXPECT_EQ(report.finding, PortFinding::garbled);
  EXPECT_NE(report.sentence().find("$GPRMC<0D>"), std::string::npos) << report.sentence();
  EXPECT_EQ(report.address(), "");
  ::close(master), ::close(slave);
}

TEST_F(Scan, PortsInUseOrMissingAreReportedAndTheOthersStillAsked) {
  const auto host = serve("stage", 9600), other = serve("other", 9600);
  const auto held = open_serial(clock, folder / "other", 9600);
  std::vector<std::string> reported;
  auto task = scan_ports(clock, {port(folder / "other"), port("/dev/ttyUSB77"), port(folder / "stage")},
                         [&](const PortReport& report) { reported.push_back(report.port.path); });
  const auto reports = run_task(io, std::move(task));
  ASSERT_EQ(reports.size(), 3u);
  EXPECT_EQ(reports[0].finding, PortFinding::busy);
  EXPECT_NE(reports[0].sentence().find("in use"), std::string::npos);
  EXPECT_EQ(reports[1].finding, PortFinding::unusable);
  EXPECT_EQ(reports[2].finding, PortFinding::answers);
  EXPECT_EQ(reported.size(), 3u);
}

}  // namespace
}  // namespace hw
