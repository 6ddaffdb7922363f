// An emulator that is served to other programs: who comes, what they hear, and that they go when it ends.
#include "transports/emulator_service.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/time/real_scheduler.h"
#include "tests/transports/ear.h"
#include "tests/transports/pseudo_terminal.h"
#include "tests/transports/toy_emulator.h"
#include "transports/serial.h"
#include "transports/tcp.h"

namespace hw {
namespace {

using test::Ear;
using test::poll_until;
using test::run_task;
using test::ToyEmulator;
using namespace std::string_literals;

class ServedEmulator : public ::testing::Test {
 protected:
  ServedEmulator() {
    host = *EmulatorHost::make(clock, std::make_unique<ToyEmulator>(), {});
    service = start({0, test::has_pseudo_terminals() ? terminal : ""});
  }
  ~ServedEmulator() override { std::filesystem::remove(terminal); }

  std::unique_ptr<EmulatorService> start(const EmulatorService::Place& place) {
    auto started = EmulatorService::start(clock, host, place, [this](int n) { counted.push_back(n); });
    EXPECT_TRUE(started) << started.error().sentence();
    return std::move(*started);
  }
  bool received(Ear& ear, std::size_t bytes) {
    return poll_until(io, [&] { return ear.received.size() >= bytes; });
  }

  std::string terminal = std::filesystem::temp_directory_path() / ("hw-served-" + std::to_string(::getpid()));
  IoContext io{1};
  RealScheduler clock{io};
  std::vector<int> counted;
  std::shared_ptr<EmulatorHost> host;
  std::unique_ptr<EmulatorService> service;
};

TEST_F(ServedEmulator, AnswersOverTcpAndCountsItsClients) {
  auto client = *run_task(io, open_tcp(clock, service->address()));
  Ear ear(*client);
  client->send("X");
  EXPECT_TRUE(received(ear, 9)) << ear.received;
  EXPECT_EQ(counted, (std::vector<int>{1}));
  client.reset();
  EXPECT_TRUE(poll_until(io, [&] { return counted.size() > 1; }));
  EXPECT_EQ(counted, (std::vector<int>{1, 0}));
}

TEST_F(ServedEmulator, AnswersOnAPseudoTerminalAsOnASerialPort) {
  HW_NEEDS_PSEUDO_TERMINAL();
  auto port = *open_serial(clock, terminal, 9600);
  Ear ear(*port);
  port->send("X");
  EXPECT_TRUE(received(ear, 9)) << ear.received;
  EXPECT_TRUE(counted.empty()) << "who is at a terminal cannot be counted";
}

TEST_F(ServedEmulator, SendsEverybodyAwayWhenItEnds) {
  auto client = *run_task(io, open_tcp(clock, service->address()));
  Ear ear(*client);
  client->send("X");
  ASSERT_TRUE(received(ear, 9));
  const std::string where = service->address();
  service.reset();
  EXPECT_TRUE(poll_until(io, [&] { return ear.closed.has_value(); }));
  EXPECT_FALSE(run_task(io, open_tcp(clock, where))) << "nobody listens there any more";
  EXPECT_FALSE(std::filesystem::exists(terminal));
  auto another = host->plug_in();
  ASSERT_TRUE(another) << "the emulator goes on without them";
  Ear still(**another);
  (*another)->send("X");
  EXPECT_TRUE(received(still, 9)) << still.received;
}

TEST_F(ServedEmulator, OfABusEveryDeviceAnswers) {
  host = *make_private_host(clock, *Address::parse("dmx-k-sa@emulator,id=01-02"));
  ASSERT_EQ(host->device_count(), 2u);
  service = start({0, {}});
  auto client = *run_task(io, open_tcp(clock, service->address()));
  Ear ear(*client);
  client->send("@01DN\r");
  ASSERT_TRUE(received(ear, 6)) << ear.received;
  client->send("@02DN\r");
  ASSERT_TRUE(received(ear, 12)) << ear.received;
  EXPECT_EQ(ear.received, "DMK01\0DMK02\0"s);
}

TEST_F(ServedEmulator, TakesAnotherPortWhereTheUsualOneIsTaken) {
  const int taken = std::stoi(service->address().substr(service->address().rfind(':') + 1));
  const auto second = start({taken, {}});
  EXPECT_NE(second->address(), service->address());
  EXPECT_TRUE(second->terminal().empty());
}

}  // namespace
}  // namespace hw
