#include "transports/open.h"

#include <filesystem>
#include <fstream>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include "core/session/transport_list.h"
#include "tests/transports/ear.h"
#include "tests/transports/pseudo_terminal.h"
#include "tests/transports/toy_emulator.h"

namespace hw {
namespace {

using test::Ear;

Result<Catalog> toy_catalog(const DeviceOptions&) {
  Catalog catalog;
  catalog.model = "toy";
  catalog.axes = {AxisInfo{"1", "motor 1"}};
  catalog.inputs = {InputInfo{"In 1", "", true}};  // which the toy does not have
  return catalog;
}
Result<std::unique_ptr<Emulator>> make_toy(const DeviceOptions& keys) {
  for (const auto& [key, value] : keys)
    if (key != "motors") return fail(FaultKind::text, "The toy has no option \"" + key + "\".");
  return std::make_unique<test::ToyEmulator>();
}
const DeviceType toy_type{"toy", toy_catalog, nullptr, make_toy, nullptr, nullptr, "V", nullptr};

class Open : public ::testing::Test {
 protected:
  Result<std::shared_ptr<EmulatorHost>> make(DeviceOptions keys) {
    const OpenOptions options;
    return make_emulator_host(clock, toy_type, std::move(keys), {}, options);
  }
  std::string refusal(DeviceOptions keys) {
    const auto host = make(std::move(keys));
    EXPECT_FALSE(host);
    return host ? "" : host.error().sentence();
  }
  Result<Wire> open(const std::string& text, std::shared_ptr<BenchAccess> again = nullptr) {
    const auto address = Address::parse(text);
    if (!address) return fail(address.error());
    return test::run_task(io, opener(clock, *address, std::move(again)));
  }

  IoContext io{1};
  VirtualScheduler clock{io};
  WireOpener opener = make_wire_opener();
};

TEST_F(Open, EveryTransportOfTheListIsOpened) {
  for (const TransportInfo& transport : transports()) {
    const bool window = transport.reaches == TransportInfo::Reaches::windows;
    const char* model = window ? "vme58" : transport.is_usb ? "pmx-4ex-sa" : "vxm";
    const bool has_place = transport.place == TransportInfo::Place::needed;
    const auto wire = open(fmt::format("{}@{}{}", model, transport.name, has_place ? ":/nowhere" : ""));
    if (wire) continue;
    EXPECT_EQ(wire.error().sentence().find("cannot be reached by"), std::string::npos) << transport.name;
  }
}

TEST_F(Open, TheTransportsKeysAreTakenTheOthersGoToTheDevice) {
  const auto host = make({{"wire", "real"}, {"speed", "2.5"}, {"motors", "4"}});
  ASSERT_TRUE(host) << host.error().sentence();
  EXPECT_TRUE((*host)->options().byte_times);
  EXPECT_EQ((*host)->options().speed, 2.5);
  EXPECT_FALSE((*make({}))->options().byte_times);
}

TEST_F(Open, ABadOptionIsRefusedWithItsReason) {
  EXPECT_NE(refusal({{"wire", "wet"}}).find("wire=wet"), std::string::npos);
  EXPECT_NE(refusal({{"speed", "fast"}}).find("speed=fast"), std::string::npos);
  EXPECT_NE(refusal({{"speed", "0"}}).find("above 0"), std::string::npos);
  EXPECT_NE(refusal({{"speed", "inf"}}).find("speed=inf"), std::string::npos);
  EXPECT_NE(refusal({{"moters", "4"}}).find("moters"), std::string::npos);
  EXPECT_NE(refusal({{"bench", "/no/such.toml"}}).find("/no/such.toml"), std::string::npos);
}

TEST_F(Open, ABenchFileIsApplied) {
  const auto file =
      std::filesystem::temp_directory_path() / ("hw-bench-" + std::to_string(::getpid()) + ".toml");
  std::ofstream(file) << "[input]\n1 = true\n";
  EXPECT_NE(refusal({{"bench", file}}).find("no such thing"), std::string::npos);
  std::ofstream(file) << "[[at]]\nt = 0.5\npower_cycle = []\n";
  const auto host = make({{"bench", file}});
  ASSERT_TRUE(host) << host.error().sentence();
  auto stream = *(*host)->plug_in();
  Ear ear(*stream, &clock);
  clock.run_for(Millis(1000));
  ASSERT_EQ(ear.received, "J");
  EXPECT_EQ(ear.times[0], Instant(Millis(500)));
  std::filesystem::remove(file);
}

TEST_F(Open, APortThatIsNotThere) {
  const auto wire = open("vxm@serial:/dev/ttyUSB77");
  ASSERT_FALSE(wire);
  EXPECT_NE(wire.error().what.find("/dev/ttyUSB77"), std::string::npos);
}

TEST_F(Open, ARateThatIsNone) {
  const auto wire = open("vxm@serial:/dev/ttyUSB77,baud=fast");
  ASSERT_FALSE(wire);
  EXPECT_NE(wire.error().what.find("baud=fast"), std::string::npos);
}

TEST_F(Open, ATransportOfAnotherModel) {
  const auto wire = open("vxm@vme:/dev/vme0");
  ASSERT_FALSE(wire);
  EXPECT_NE(wire.error().sentence().find("serial, tcp, rfc2217"), std::string::npos)
      << wire.error().sentence();
}

class OpenVxm : public Open {
 protected:
  void SetUp() override {
    if (!find_device_type("vxm")->make_emulator) GTEST_SKIP() << "no emulated VXM in this build";
  }
};

TEST_F(OpenVxm, AnEmulatorOfThisProcess) {
  auto wire = open("vxm@emulator,motors=2");
  ASSERT_TRUE(wire) << wire.error().sentence();
  ASSERT_EQ(wire->benches.size(), 1u);
  Ear ear(*wire->stream);
  wire->stream->send("V");
  clock.run_for(Millis(10));
  EXPECT_EQ(ear.received, "J");
  EXPECT_EQ(wire->stream->rate(), 0);
}

TEST_F(OpenVxm, AfterAPulledCableItIsTheSameOne) {
  auto wire = open("vxm@emulator");
  ASSERT_TRUE(wire);
  const auto bench = wire->benches.front();
  ASSERT_TRUE(bench->operate(bench::Unplug(true)));
  EXPECT_FALSE(open("vxm@emulator", bench));
  ASSERT_TRUE(bench->operate(bench::Unplug(false)));
  auto again = open("vxm@emulator", bench);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->benches.front(), bench);
}

TEST_F(OpenVxm, AtAnotherRateItIsNotUnderstood) {
  auto wire = open("vxm@emulator,wire=real,baud=38400");
  ASSERT_TRUE(wire) << wire.error().sentence();
  EXPECT_EQ(wire->stream->rate(), 38400);
  Ear ear(*wire->stream);
  wire->stream->send("V");
  clock.run_for(Millis(50));
  EXPECT_EQ(ear.received, "");
}

// A controller that is closed lets its port go a moment later.
struct OpenAgain : Open {
  void SetUp() override {
    HW_NEEDS_PSEUDO_TERMINAL();
    int slave = -1;
    char name[64];
    ASSERT_EQ(::openpty(&master, &slave, name, nullptr, nullptr), 0);
    ::close(slave);
    address = fmt::format("vxm@serial:{}", name);
  }
  ~OpenAgain() override {
    if (master >= 0) ::close(master);
  }
  /// Begins to open it, and runs for `time`.
  void begin(Duration time) {
    asio::co_spawn(io.get_executor(), opener(clock, *Address::parse(address), nullptr),
                   [this](std::exception_ptr, Result<Wire> wire) { result.emplace(std::move(wire)); });
    clock.run_for(time);
  }

  int master = -1;
  std::string address;
  std::optional<Result<Wire>> result;
};

TEST_F(OpenAgain, WaitsUntilThisProgramHasLetThePortGo) {
  auto before = open(address);
  ASSERT_TRUE(before) << before.error().sentence();
  begin(Millis(200));
  ASSERT_FALSE(result) << (*result ? "" : result->error().sentence());
  before->stream.reset();
  clock.run_for(Millis(50));
  ASSERT_TRUE(result);
  EXPECT_TRUE(*result);
}

TEST_F(OpenAgain, DoesNotWaitForEver) {
  auto before = open(address);
  ASSERT_TRUE(before);
  begin(std::chrono::seconds(4));
  ASSERT_TRUE(result);
  ASSERT_FALSE(*result);
  EXPECT_NE(result->error().what.find("this program itself holds it"), std::string::npos);
}

TEST_F(OpenVxm, AMisspeltKeyIsReportedForRealPortsToo) {
  const auto wire = open("vxm@tcp:127.0.0.1:1,moters=4");
  ASSERT_FALSE(wire);
  EXPECT_NE(wire.error().what.find("moters"), std::string::npos);
}

}  // namespace
}  // namespace hw
