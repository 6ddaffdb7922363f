// The bus over TCP: bytes of the contract, both ends, peers that misbehave.
#include "transports/bus_port.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/transports/ear.h"
#include "tests/transports/toy_board.h"
#include "transports/serve.h"
#include "transports/tcp.h"
#include "transports/tcp_endpoint.h"

namespace hw {
namespace {

using test::Ear;
using test::poll_until;
using test::run_task;
using test::ToyBoard;
using test::WindowEar;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class BusPortTest : public testing::Test {
 protected:
  BusPortTest() {
    auto toy = std::make_unique<ToyBoard>();
    board = toy.get();
    host = *EmulatorHost::make(clock, std::move(toy), HostOptions(),
                               [this](const Fault& fault) { troubles.push_back(fault.sentence()); });
    endpoint = *TcpEndpoint::open(clock, "127.0.0.1:0", false,
                                  [this](std::unique_ptr<Stream> s) { host->attach_bus(std::move(s)); });
  }
  std::unique_ptr<Stream> raw() { return std::move(*run_task(io, open_tcp(clock, endpoint->address()))); }
  std::unique_ptr<Window> window() {
    return std::move(*run_task(io, open_bus_port(clock, endpoint->address())));
  }

  IoContext io{1};
  RealScheduler clock{io};
  ToyBoard* board = nullptr;
  std::shared_ptr<EmulatorHost> host;
  std::unique_ptr<TcpEndpoint> endpoint;
  std::vector<std::string> troubles;
};

std::string bytes(std::initializer_list<int> values) {
  std::string all;
  for (const int v : values) all += static_cast<char>(v);
  return all;
}

TEST_F(BusPortTest, SpeaksTheBytesOfTheContract) {
  auto client = raw();
  Ear ear(*client);
  client->send(bytes({0x81, 0x00, 0x10, 0xAB}));                    // write 8
  client->send(bytes({0x82, 0x08, 0x04, 0x00, 0x41}));              // write 16
  client->send(bytes({0x84, 0x04, 0x00, 0xFF, 0xFE, 0xDC, 0xBA}));  // write 32
  client->send(bytes({0x01, 0x00, 0x10, 0x02, 0x08, 0x04, 0x04, 0x04, 0x00}));
  ASSERT_TRUE(poll_until(io, [&] { return ear.received.size() >= 7; }));
  EXPECT_EQ(ear.received, bytes({0xAB, 0x00, 0x41, 0xFF, 0xFE, 0xDC, 0xBA}));
  EXPECT_THAT(board->cycles, ElementsAre("w8 010 AB", "w16 804 0041", "w16 400 FFFE", "w16 402 DCBA",
                                         "r8 010", "r16 804", "r16 400", "r16 402"));
}

TEST_F(BusPortTest, AMessageMayComeInPieces) {
  auto client = raw();
  Ear ear(*client);
  const std::string message = bytes({0x82, 0x08, 0x04, 0x12, 0x34, 0x02, 0x08, 0x04});
  for (const char c : message) {
    client->send(std::string(1, c));
    for (int i = 0; i < 3; ++i) io.poll();
  }
  ASSERT_TRUE(poll_until(io, [&] { return ear.received.size() >= 2; }));
  EXPECT_EQ(ear.received, bytes({0x12, 0x34}));
}

TEST_F(BusPortTest, AnInvalidMessageEndsTheConnectionAndNotTheBoard) {
  auto client = raw();
  Ear ear(*client);
  client->send("GET / HTTP/1.1\r\n");
  ASSERT_TRUE(poll_until(io, [&] { return ear.closed; }));
  EXPECT_TRUE(board->cycles.empty());
  EXPECT_THAT(troubles,
              ElementsAre(AllOf(HasSubstr("sent 47 instead of an operation"),
                                HasSubstr("Its connection was closed"), HasSubstr("81, 82 and 84"))))
      << "once";
  auto good = window();
  std::vector<BusCycle> burst{BusCycle::store(1, 3, 9), BusCycle::read(1, 3)};
  ASSERT_TRUE(run_task(io, good->run(burst)));
  EXPECT_EQ(burst[1].value, 9u);
}

TEST_F(BusPortTest, ACycleBeyondTheWindowEndsTheConnectionAndReachesNoBoard) {
  for (const auto& beyond : {bytes({0x02, 0x10, 0x00}), bytes({0x81, 0xFF, 0xFF, 0x01}),
                             bytes({0x04, 0x0F, 0xFE}), bytes({0x01, 0x10, 0x00})}) {
    auto client = raw();
    Ear ear(*client);
    client->send(beyond);
    ASSERT_TRUE(poll_until(io, [&] { return ear.closed; }));
    EXPECT_EQ(ear.received, "");
  }
  EXPECT_TRUE(board->cycles.empty());
  EXPECT_THAT(troubles,
              ElementsAre(HasSubstr("asked for 2 bytes at 0x1000"), HasSubstr("wrote 1 byte at 0xFFFF"),
                          HasSubstr("asked for 4 bytes at 0xFFE"), HasSubstr("asked for 1 byte at 0x1000")));
  auto client = raw();
  Ear ear(*client);
  client->send(bytes({0x01, 0x0F, 0xFF, 0x02, 0x0F, 0xFE, 0x04, 0x0F, 0xFC}));
  ASSERT_TRUE(poll_until(io, [&] { return ear.received.size() >= 7; })) << "its last bytes";
}

TEST_F(BusPortTest, BothEndsAgree) {
  auto client = window();
  std::vector<BusCycle> burst{BusCycle::store(4, 0x404, 0x01020304), BusCycle::read(1, 0x406),
                              BusCycle::read(2, 0x404), BusCycle::read(4, 0x404)};
  ASSERT_TRUE(run_task(io, client->run(burst)));
  EXPECT_EQ(burst[1].value, 0x03u);
  EXPECT_EQ(burst[2].value, 0x0102u);
  EXPECT_EQ(burst[3].value, 0x01020304u);
  EXPECT_FALSE(client->reports_interrupts());
}

TEST_F(BusPortTest, AnEndOfTheServerIsReportedAndEndsWhatIsUnderWay) {
  std::unique_ptr<Stream> far;
  auto silent =
      *TcpEndpoint::open(clock, "127.0.0.1:0", false, [&](std::unique_ptr<Stream> s) { far = std::move(s); });
  auto client = std::move(*run_task(io, open_bus_port(clock, silent->address())));
  ASSERT_TRUE(poll_until(io, [&] { return far != nullptr; }));
  WindowEar ear(*client);
  std::vector<BusCycle> burst{BusCycle::read(2, 0)};
  std::optional<Result<>> ended;
  asio::co_spawn(io, client->run(burst), [&](std::exception_ptr, Result<> r) { ended = std::move(r); });
  io.poll();
  EXPECT_FALSE(ended);
  far.reset();
  ASSERT_TRUE(poll_until(io, [&] { return ended.has_value() && ear.gone; }));
  EXPECT_FALSE(*ended);
  EXPECT_THAT(ear.gone->sentence(), HasSubstr("The other side"));  // closed it, or broke it off
}

TEST_F(BusPortTest, NothingListensIsASentence) {
  const std::string where = endpoint->address();
  endpoint.reset();
  const auto opened = run_task(io, open_bus_port(clock, where));
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().sentence(), HasSubstr("nothing listens"));
}

}  // namespace
}  // namespace hw
