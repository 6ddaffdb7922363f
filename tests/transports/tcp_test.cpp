#include "transports/tcp.h"

#include <boost/asio/ip/tcp.hpp>

#include <gtest/gtest.h>

#include "core/base/asio.h"
#include "tests/transports/ear.h"
#include "transports/tcp_endpoint.h"

namespace hw {
namespace {

using test::Ear;
using test::poll_until;
using test::run_task;

class TcpTransport : public ::testing::Test {
 protected:
  TcpTransport() {
    auto opened = TcpEndpoint::open(clock, "127.0.0.1:0", false,
                                    [this](std::unique_ptr<Stream> s) { accepted.push_back(std::move(s)); });
    endpoint = std::move(*opened);
  }
  std::unique_ptr<Stream> connect() {
    const std::size_t before = accepted.size();
    auto stream = run_task(io, open_tcp(clock, endpoint->address()));
    EXPECT_TRUE(stream);
    EXPECT_TRUE(poll_until(io, [&] { return accepted.size() > before; }));
    return std::move(*stream);
  }

  IoContext io{1};
  RealScheduler clock{io};
  std::vector<std::unique_ptr<Stream>> accepted;
  std::unique_ptr<TcpEndpoint> endpoint;
};

TEST_F(TcpTransport, CarriesBytesBothWays) {
  auto near = connect();
  Ear at_near(*near), at_far(*accepted[0]);
  near->send("X");
  ASSERT_TRUE(poll_until(io, [&] { return at_far.received == "X"; }));
  accepted[0]->send("+0000400\r");
  ASSERT_TRUE(poll_until(io, [&] { return at_near.received == "+0000400\r"; }));
}

// A motion command that waits in a dead network must not start when the network is back.
TEST_F(TcpTransport, UnsentBytesOfADroppedConnectionNeverArrive) {
  auto near = connect();
  const std::string much(700'000, 'X');
  near->send(much);  // nobody reads yet: most of it waits in the two kernels
  near->send(much);
  near->discard_unsent();
  near.reset();
  Ear at_far(*accepted[0]);
  ASSERT_TRUE(poll_until(io, [&] { return at_far.closed; }));
  EXPECT_LT(at_far.received.size(), 2 * much.size());
}

TEST_F(TcpTransport, ReportsThePortItReallyHas) {
  EXPECT_TRUE(endpoint->address().starts_with("127.0.0.1:"));
  EXPECT_FALSE(endpoint->address().ends_with(":0"));
}

TEST_F(TcpTransport, SeveralClientsAtOnce) {
  auto a = connect();
  auto b = connect();
  Ear at_a(*a), at_b(*b);
  for (const auto& stream : accepted) stream->send("hello");
  EXPECT_TRUE(poll_until(io, [&] { return at_a.received == "hello" && at_b.received == "hello"; }));
}

TEST_F(TcpTransport, ThePeerLeaving) {
  auto near = connect();
  Ear ear(*near);
  accepted.clear();
  ASSERT_TRUE(poll_until(io, [&] { return ear.closed.has_value(); }));
  EXPECT_EQ(ear.closed->kind, FaultKind::lost);
  EXPECT_EQ(ear.closed->done, "Commands on the way may have been carried out.");
  EXPECT_NE(ear.closed->what.find(endpoint->address()), std::string::npos);
  near->send("into the void");
}

TEST_F(TcpTransport, AStreamMayBeDestroyedInItsOwnCallback) {
  auto near = connect();
  Ear ear(*near), far(*accepted[0]);
  ear.on_bytes = [&] { near.reset(); };
  accepted[0]->send("x");
  ASSERT_TRUE(poll_until(io, [&] { return !near; }));
  EXPECT_TRUE(poll_until(io, [&] { return far.closed.has_value(); }));
}

TEST_F(TcpTransport, AStreamMayBeDestroyedWhenItCloses) {
  auto near = connect();
  Ear ear(*near);
  ear.on_close = [&] { near.reset(); };
  accepted.clear();
  EXPECT_TRUE(poll_until(io, [&] { return !near; }));
}

TEST_F(TcpTransport, AFloodArrivesWhole) {
  auto near = connect();
  Ear ear(*near), far(*accepted[0]);
  const std::string block(64 * 1024, 'x');
  std::size_t received = 0;
  ear.on_bytes = [&] { received += ear.received.size(), ear.received.clear(); };
  for (int i = 0; i < 800; ++i) {  // 50 MB; no more than the queue bears at a time
    accepted[0]->send(block);
    const std::size_t so_far = static_cast<std::size_t>(i + 1) * block.size();
    ASSERT_TRUE(poll_until(io, [&] { return received + 512 * 1024 >= so_far; }));
  }
  EXPECT_TRUE(poll_until(io, [&] { return received == 800 * block.size(); }));
}

TEST_F(TcpTransport, AClientThatNeverReadsIsLeft) {
  auto near = connect();  // nobody listens here, so nobody reads
  Ear far(*accepted[0]);
  const std::string block(64 * 1024, 'x');
  for (int i = 0; i < 1000 && !far.closed; ++i) {
    accepted[0]->send(block);
    io.restart();
    io.poll();
  }
  ASSERT_TRUE(far.closed);
  EXPECT_NE(far.closed->what.find("stopped reading"), std::string::npos);
}

TEST_F(TcpTransport, NothingListens) {
  const std::string where = endpoint->address();
  endpoint.reset();
  const auto stream = run_task(io, open_tcp(clock, where));
  ASSERT_FALSE(stream);
  EXPECT_EQ(stream.error().kind, FaultKind::port);
  EXPECT_NE(stream.error().what.find(where), std::string::npos);
  EXPECT_NE(stream.error().what.find("nothing listens"), std::string::npos);
}

TEST_F(TcpTransport, AnUnknownHost) {
  const auto stream = run_task(io, open_tcp(clock, "no-such-host.invalid:4001", Millis(2000)), Millis(30000));
  ASSERT_FALSE(stream);
  EXPECT_NE(stream.error().what.find("no-such-host.invalid:4001"), std::string::npos);
}

TEST_F(TcpTransport, AHostNameIsLookedUp) {
  boost::system::error_code unknown;
  (void)asio::ip::tcp::resolver(io).resolve("localhost", "", unknown);
  if (unknown) GTEST_SKIP() << "This machine does not know its own name.";
  const std::string port = endpoint->address().substr(endpoint->address().find(':'));
  auto stream = run_task(io, open_tcp(clock, "localhost" + port));
  EXPECT_TRUE(stream) << stream.error().sentence();
}

// A server that never accepts, its queue full: the kernel lets further connections hang.
TEST_F(TcpTransport, AServerThatDoesNotAnswerIsGivenUp) {
  asio::ip::tcp::acceptor deaf(io);
  const asio::ip::tcp::endpoint any(asio::ip::address_v4::loopback(), 0);
  deaf.open(any.protocol());
  deaf.bind(any);
  deaf.listen(0);
  asio::ip::tcp::socket filler(io);
  filler.connect(deaf.local_endpoint());
  const std::string where = "127.0.0.1:" + std::to_string(deaf.local_endpoint().port());
  const auto stream = run_task(io, open_tcp(clock, where, Millis(50)));
  ASSERT_FALSE(stream);
  EXPECT_NE(stream.error().what.find("no answer in time"), std::string::npos);
}

TEST_F(TcpTransport, ATakenPortIsReported) {
  const auto second = TcpEndpoint::open(clock, endpoint->address(), false, {});
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().what.find("another program"), std::string::npos);
}

TEST_F(TcpTransport, OnlyThisMachineUnlessAllowed) {
  const auto refused = TcpEndpoint::open(clock, "0.0.0.0:0", false, {});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("--allow-remote"), std::string::npos);
  const auto allowed = TcpEndpoint::open(clock, "0.0.0.0:0", true, {});
  EXPECT_TRUE(allowed);
}

}  // namespace
}  // namespace hw
